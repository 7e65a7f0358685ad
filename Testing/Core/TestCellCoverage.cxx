// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellCoverage.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace bravais;

namespace
{

using Weights = std::map<std::pair<int, int>, double>;
using Polygon = std::vector<glm::dvec2>;

Weights Cover(const CellCoverage& cell, const glm::dvec2& center)
{
  Weights result;
  CellCoverage::Row row = cell.MakeRow();
  cell.ForEachRow(center, row,
    [&](int y, int x, int count, const double* weights)
    {
      for (int i = 0; i < count; ++i)
      {
        result[{ x + i, y }] += weights[i];
      }
    });
  return result;
}

/// The part of a polygon where a x + b y >= c.
Polygon Clip(const Polygon& polygon, double a, double b, double c)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 p = polygon[i];
    const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
    const double dp = a * p.x + b * p.y - c;
    const double dq = a * q.x + b * q.y - c;
    if (dp >= 0.0)
    {
      result.push_back(p);
    }
    if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0))
    {
      result.push_back(p + (q - p) * (dp / (dp - dq)));
    }
  }
  return result;
}

double GetArea(const Polygon& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 p = polygon[i];
    const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * twice;
}

std::vector<std::array<glm::dvec2, 6>> MakeCells()
{
  std::vector<std::array<glm::dvec2, 6>> cells;
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    if (lattice.GetSize().x < 100.0)
    {
      for (const double scale : { 0.02, 0.31, 1.0 })
      {
        auto cell = lattice.GetVoronoiCell();
        for (glm::dvec2& corner : cell)
        {
          corner *= scale * glm::dvec2(1.0, 0.7);
        }
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

} // namespace

TEST(TestCellCoverage, IsTheAreaInEachPixel)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> anywhere(-20.0, 20.0);
  for (const auto& corners : MakeCells())
  {
    const CellCoverage cell(corners);
    for (int repeat = 0; repeat < 4; ++repeat)
    {
      const glm::dvec2 center =
        repeat ? glm::dvec2(anywhere(generator), anywhere(generator)) : glm::dvec2(3.0, -2.0);
      Polygon polygon;
      for (const glm::dvec2& corner : corners)
      {
        polygon.push_back(center + corner);
      }
      EXPECT_NEAR(cell.GetArea(), GetArea(polygon), 1e-12 * (1.0 + 400.0 * cell.GetArea()));
      double sum = 0.0;
      for (const auto& [pixel, weight] : Cover(cell, center))
      {
        const auto [x, y] = pixel;
        const Polygon part =
          Clip(Clip(Clip(Clip(polygon, 1, 0, x), -1, 0, -x - 1), 0, 1, y), 0, -1, -y - 1);
        ASSERT_NEAR(weight, GetArea(part) / cell.GetArea(), 1e-9) << x << " " << y;
        sum += weight;
      }
      EXPECT_NEAR(sum, 1.0, 1e-11);
    }
  }
}

TEST(TestCellCoverage, AlignedSquaresCoverWholePixels)
{
  const CellCoverage cell({ { { 1.0, -1.0 }, { 1.0, 1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 },
    { -1.0, -1.0 }, { -1.0, -1.0 } } });
  EXPECT_EQ(cell.GetArea(), 4.0);
  for (const auto& [pixel, weight] : Cover(cell, { 5.0, 7.0 }))
  {
    const auto [x, y] = pixel;
    EXPECT_EQ(weight, x >= 4 && x < 6 && y >= 6 && y < 8 ? 0.25 : 0.0) << x << " " << y;
  }
}
