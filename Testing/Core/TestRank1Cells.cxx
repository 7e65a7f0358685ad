// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Rank1Cells.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <random>

using namespace bravais;

namespace
{

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

double GetArea(const Rank1Cells::Part& part)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    twice += Cross(part[i].Position, part[(i + 1) % part.size()].Position);
  }
  return 0.5 * twice;
}

/// Whether a point is in a convex part, by more than rounding.
bool Contains(const Rank1Cells::Part& part, const glm::dvec2& point)
{
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    const glm::dvec2 p = part[i].Position;
    const glm::dvec2 q = part[(i + 1) % part.size()].Position;
    if (Cross(q - p, point - p) < -1e-12)
    {
      return false;
    }
  }
  return true;
}

struct Cover
{
  std::vector<Rank1Cells::Part> Parts;
  std::vector<Rank1Cells::Triangle> Triangles; ///< of each part
  std::vector<std::int64_t> Texels;            ///< of each part
};

Cover FindCells(const Rank1Cells& cells)
{
  Cover cover;
  std::vector<Rank1Cells::Part> parts;
  for (std::int64_t texel = 0; texel < cells.GetNumberOfTexels(); ++texel)
  {
    cells.FindCellParts(texel, parts);
    cover.Parts.insert(cover.Parts.end(), parts.begin(), parts.end());
    cover.Texels.insert(cover.Texels.end(), parts.size(), texel);
  }
  return cover;
}

Cover FindTriangles(const Rank1Cells& cells)
{
  Cover cover;
  std::vector<Rank1Cells::Part> parts;
  for (std::int64_t texel = 0; texel < cells.GetNumberOfTexels(); ++texel)
  {
    for (const int which : { 0, 1 })
    {
      const Rank1Cells::Triangle triangle = cells.GetTriangle(texel, which);
      cells.FindTriangleParts(triangle, parts);
      if (triangle.IsInside)
      {
        EXPECT_EQ(parts.size(), 1u);
      }
      cover.Parts.insert(cover.Parts.end(), parts.begin(), parts.end());
      cover.Triangles.insert(cover.Triangles.end(), parts.size(), triangle);
    }
  }
  return cover;
}

/// Areas sum to 1, no part is turned over or beyond the border, and random points are in one part.
void CheckCover(const Cover& cover)
{
  double sum = 0.0;
  for (const Rank1Cells::Part& part : cover.Parts)
  {
    const double area = GetArea(part);
    EXPECT_GE(area, -1e-15);
    sum += area;
    for (const Rank1Cells::Corner& corner : part)
    {
      EXPECT_GE(std::min(corner.Position.x, corner.Position.y), 0.0);
      EXPECT_LE(std::max(corner.Position.x, corner.Position.y), 1.0);
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-11);
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  for (int repeat = 0; repeat < 50; ++repeat)
  {
    const glm::dvec2 point(anywhere(generator), anywhere(generator));
    int count = 0;
    for (const Rank1Cells::Part& part : cover.Parts)
    {
      count += Contains(part, point) ? 1 : 0;
    }
    EXPECT_EQ(count, 1);
  }
}

const glm::ivec2 TileNumbers[] = { { 1, 1 }, { 3, 2 } };

} // namespace

TEST(TestRank1Cells, VoronoiCellsCoverThePictureOnce)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (const glm::ivec2& tiles : TileNumbers)
    {
      if (lattice.GetNumberOfPoints() < 300)
      {
        CheckCover(FindCells(Rank1Cells(lattice, tiles.x, tiles.y)));
      }
    }
  }
}

TEST(TestRank1Cells, TrianglesCoverThePictureOnce)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (const glm::ivec2& tiles : TileNumbers)
    {
      if (lattice.GetNumberOfPoints() < 300)
      {
        CheckCover(FindTriangles(Rank1Cells(lattice, tiles.x, tiles.y)));
      }
    }
  }
}

TEST(TestRank1Cells, PartsAreOfTheNearestTexel)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(56, 4, 7, { 3.0, 2.0 });
  const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice, 3, 2);
  const Cover cover = FindCells(Rank1Cells(lattice, 3, 2));
  for (std::size_t i = 0; i < cover.Parts.size(); ++i)
  {
    glm::dvec2 middle(0.0);
    for (const Rank1Cells::Corner& corner : cover.Parts[i])
    {
      middle += corner.Position / static_cast<double>(cover.Parts[i].size());
    }
    EXPECT_EQ(FindRank1Nearest(texture, middle), cover.Texels[i]);
  }
}

TEST(TestRank1Cells, TrianglesAreThoseOfBarycentricInterpolation)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice, 3, 2);
    if (lattice.GetNumberOfPoints() < 100)
    {
      const Cover cover = FindTriangles(Rank1Cells(lattice, 3, 2));
      for (std::size_t i = 0; i < cover.Parts.size(); ++i)
      {
        glm::dvec2 middle(0.0);
        glm::dvec3 barycentric(0.0);
        const double share = 1.0 / static_cast<double>(cover.Parts[i].size());
        for (const Rank1Cells::Corner& corner : cover.Parts[i])
        {
          middle += corner.Position * share;
          barycentric += corner.Barycentric * share;
        }
        std::int64_t texels[3];
        double weights[3];
        FindRank1Barycentric(texture, middle, texels, weights);
        // The same function of all texels, told by a sum that differs for each.
        double found = 0.0;
        double expected = 0.0;
        for (int vertex = 0; vertex < 3; ++vertex)
        {
          found +=
            barycentric[vertex] * std::sqrt(static_cast<double>(cover.Triangles[i].Texels[vertex]));
          expected += weights[vertex] * std::sqrt(static_cast<double>(texels[vertex]));
        }
        ASSERT_NEAR(found, expected, 1e-7);
      }
    }
  }
}
