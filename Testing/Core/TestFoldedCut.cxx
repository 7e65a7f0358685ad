// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoldedCut.h"
#include "SpringEmbedding.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using bravais::HalfTurn;
using bravais::TriangleTopology;

/// A closed mesh: rings of a ball, the poles first and last.
void MakeBall(int rings, int sides, std::vector<glm::dvec3>& points, TriangleTopology& mesh)
{
  std::vector<bravais::Triangle> triangles;
  const auto at = [&](int ring, int side) { return 1 + ring * sides + side % sides; };
  points.emplace_back(0.0, 0.0, 1.0);
  for (int ring = 0; ring < rings; ++ring)
  {
    const double polar = M_PI * (ring + 1) / (rings + 1);
    for (int side = 0; side < sides; ++side)
    {
      const double turn = 2.0 * M_PI * side / sides;
      points.emplace_back(
        std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), 1.5 * std::cos(polar));
    }
  }
  points.emplace_back(0.0, 0.0, -1.0);
  for (int side = 0; side < sides; ++side)
  {
    triangles.push_back({ { 0, at(0, side), at(0, side + 1) } });
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
      triangles.push_back({ { at(ring, side), at(ring + 1, side), at(ring + 1, side + 1) } });
      triangles.push_back({ { at(ring, side), at(ring + 1, side + 1), at(ring, side + 1) } });
    }
    triangles.push_back({ { at(rings - 1, side), 1 + rings * sides, at(rings - 1, side + 1) } });
  }
  std::string why;
  ASSERT_TRUE(mesh.Set(static_cast<int>(points.size()), triangles, why)) << why;
}

HalfTurn GetTurn(const bravais::FoldedCut& cut, int h)
{
  return cut.Corners[static_cast<std::size_t>(h)];
}

/// Whether u -> turn(u) maps the folded rectangle's cover to itself: see GixelSampling.
bool IsOfCover(const HalfTurn& turn, const glm::dvec2& size)
{
  const glm::dvec2 steps = turn.Shift / size;
  const double m = std::round(steps.x);
  const double n = std::round(steps.y);
  const bool odd = std::fmod(std::abs(m + n), 2.0) > 0.5;
  return glm::length(steps - glm::dvec2(m, n)) < 1e-9 && turn.Sign == (odd ? -1.0 : 1.0);
}

}

//------------------------------------------------------------------------------
TEST(FoldedCut, SeamsAreSymmetriesOfTheFoldedRectangle)
{
  std::vector<glm::dvec3> points;
  TriangleTopology mesh;
  MakeBall(7, 9, points, mesh);
  const glm::dvec2 size(1.0, 0.5);
  const std::array<int, 4> tips = bravais::FindTips(mesh, points);
  for (int root = 0; root < mesh.GetNumberOfVertices(); ++root)
  {
    const bravais::FoldedCut cut = bravais::CutToTips(mesh, points, root, tips, size);
    EXPECT_TRUE(std::is_permutation(tips.begin(), tips.end(), cut.Tips.begin()));
    for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      // Both ends of an edge go from one triangle to the other by one and the same map.
      const int twin = mesh.GetTwin(h);
      const HalfTurn from =
        GetTurn(cut, TriangleTopology::GetNext(twin)) * GetTurn(cut, h).Invert();
      const HalfTurn to = GetTurn(cut, twin) * GetTurn(cut, TriangleTopology::GetNext(h)).Invert();
      EXPECT_TRUE(IsOfCover(from, size));
      const bool tip = std::count(tips.begin(), tips.end(), mesh.GetOrigin(h)) > 0 ||
        std::count(tips.begin(), tips.end(), mesh.GetEnd(h)) > 0;
      if (!tip) // a tip is at its place whichever way it is turned
      {
        EXPECT_EQ(from.Sign, to.Sign);
        EXPECT_LT(glm::length(from.Shift - to.Shift), 1e-9);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(FoldedCut, AnyPositiveWeightsEmbed)
{
  std::vector<glm::dvec3> points;
  TriangleTopology mesh;
  MakeBall(7, 9, points, mesh);
  const glm::dvec2 size(1.0, 1.0);
  const std::array<glm::dvec2, 4> folds = bravais::GetFolds(size);
  for (int root = 0; root < mesh.GetNumberOfVertices(); root += 5)
  {
    const bravais::FoldedCut cut =
      bravais::CutToTips(mesh, points, root, bravais::FindTips(mesh, points), size);
    bravais::SurfaceParameters parameters{ size, cut.Corners, std::vector<char>(points.size(), 0),
      std::vector<glm::dvec2>(points.size()) };
    for (std::size_t n = 0; n < 4; ++n)
    {
      parameters.Fixed[static_cast<std::size_t>(cut.Tips[n])] = 1;
      parameters.Places[static_cast<std::size_t>(cut.Tips[n])] = folds[n];
    }
    std::vector<double> weights(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()));
    for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const int edge = std::min(h, mesh.GetTwin(h));
      weights[static_cast<std::size_t>(h)] = 0.05 + (edge * 7919 % 101) / 10.0;
    }
    ASSERT_TRUE(bravais::SpringEmbedding(mesh, parameters).Solve(weights, parameters));
    EXPECT_EQ(bravais::CountFlipped(mesh, parameters), 0);
    double area = 0.0;
    for (int t = 0; t < static_cast<int>(mesh.GetTriangles().size()); ++t)
    {
      const auto u = bravais::GetCorners(mesh, parameters, t);
      area += 0.5 * ((u[1].x - u[0].x) * (u[2].y - u[0].y) - (u[1].y - u[0].y) * (u[2].x - u[0].x));
    }
    EXPECT_NEAR(area, size.x * size.y, 1e-9); // covered once
  }
}
