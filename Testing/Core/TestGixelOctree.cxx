// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells and the octree over them, against searches of all gixels.

#include "CellGrid.h"
#include "CullOctree.h"
#include "GixelOctree.h"
#include "VolumeTest.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace
{

std::vector<glm::dvec3> MakePoints(std::size_t count, double scale, double shift)
{
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> points;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double x = normal(generator);
    const double y = normal(generator);
    points.push_back(scale * glm::dvec3(x, y, normal(generator)) + shift);
  }
  return points;
}

bravais::Box GetBox(const std::vector<glm::dvec3>& points)
{
  bravais::Box box{ points[0], points[0] };
  for (const glm::dvec3& point : points)
  {
    box = { glm::min(box.Low, point), glm::max(box.High, point) };
  }
  return box;
}

bool Holds(const bravais::Box& box, const glm::dvec3& x)
{
  return glm::all(glm::lessThanEqual(box.Low, x)) && glm::all(glm::lessThan(x, box.High));
}

} // namespace

TEST(TestGixelOctree, MortonCodesAreReadBack)
{
  EXPECT_EQ(bravais::ToMorton({ 1, 0, 0 }), 4U);
  EXPECT_EQ(bravais::ToMorton({ 0, 1, 0 }), 2U);
  EXPECT_EQ(bravais::ToMorton({ 0, 0, 1 }), 1U);
  for (std::uint32_t code = 0; code < 1U << 30; code += 999983)
  {
    EXPECT_EQ(bravais::ToMorton(bravais::FromMorton(code)), code);
  }
}

TEST(TestGixelOctree, BoxesHoldTheirPointsToTheLastBit)
{
  for (const double shift : { 0.0, 1.0 / 3.0, 1e6 })
  {
    for (const int depth : { 0, 1, 5, 10 })
    {
      const auto points = MakePoints(2000, 0.37, shift);
      const auto grid = bravais::CellGrid::CreateRound(GetBox(points), depth);
      ASSERT_TRUE(grid);
      for (const glm::dvec3& point : points)
      {
        const std::uint32_t code = grid->GetCode(point);
        ASSERT_NE(code, bravais::CellGrid::NoCell);
        for (int above = 0; above <= depth; ++above)
        {
          const glm::ivec3 cell = bravais::FromMorton(code >> 3 * (depth - above));
          const bravais::Box box = grid->GetBox(cell, above);
          EXPECT_TRUE(Holds(box, point));
        }
        // Just below a face is the cell before.
        const bravais::Box box = grid->GetBox(bravais::FromMorton(code), depth);
        for (int axis = 0; axis < 3; ++axis)
        {
          glm::dvec3 face = point;
          face[axis] = box.Low[axis];
          EXPECT_EQ(grid->GetCode(face), code);
          face[axis] = std::nextafter(box.Low[axis], -1e300);
          EXPECT_NE(grid->GetCode(face), code);
          face[axis] = box.High[axis];
          EXPECT_NE(grid->GetCode(face), code);
        }
      }
    }
  }
}

TEST(TestGixelOctree, CubesAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 zero(0.0);
  EXPECT_TRUE(bravais::CellGrid::Create(zero, 1.0, 10));
  EXPECT_FALSE(bravais::CellGrid::Create(zero, 1.0, 11));
  EXPECT_FALSE(bravais::CellGrid::Create(zero, 1.0, -1));
  EXPECT_FALSE(bravais::CellGrid::Create(zero, 0.0, 3));
  EXPECT_FALSE(bravais::CellGrid::Create(zero, nan, 3));
  EXPECT_FALSE(bravais::CellGrid::Create(glm::dvec3(nan), 1.0, 3));
  EXPECT_FALSE(bravais::CellGrid::Create(glm::dvec3(1.0), 1e-15, 3));
}

TEST(TestGixelOctree, NodesAreTheNonEmptyCells)
{
  std::mt19937 generator(5);
  for (const int depth : { 0, 1, 2, 4, 10 })
  {
    std::vector<std::uint32_t> codes(5000);
    for (std::uint32_t& code : codes)
    {
      code = generator() % 9 ? static_cast<std::uint32_t>(generator()) & ((1U << 3 * depth) - 1)
                             : bravais::CellGrid::NoCell;
    }
    const bravais::GixelOctree tree(codes, depth);
    std::size_t nodes = 0;
    for (int level = 0; level <= depth; ++level)
    {
      std::map<std::uint32_t, std::vector<std::uint32_t>> expected;
      for (std::uint32_t gixel = 0; gixel < codes.size(); ++gixel)
      {
        if (codes[gixel] != bravais::CellGrid::NoCell)
        {
          expected[codes[gixel] >> 3 * (depth - level)].push_back(gixel);
        }
      }
      const bravais::GixelOctree::Level& found = tree.GetLevel(level);
      const std::vector<std::uint32_t> sorted = tree.SortGixels(level);
      ASSERT_EQ(found.GetSize(), expected.size());
      std::size_t node = 0;
      for (const auto& [code, gixels] : expected)
      {
        EXPECT_EQ(found.Codes[node], code);
        EXPECT_EQ(std::vector<std::uint32_t>(
                    sorted.begin() + found.Gixels[node], sorted.begin() + found.Gixels[node + 1]),
          gixels);
        ++node;
      }
      nodes += expected.size();
    }
    EXPECT_EQ(tree.GetNumberOfNodes(), nodes);
  }
}

TEST(TestGixelOctree, TheSearchFindsWhatTestsOfAllLeavesFind)
{
  const auto points = MakePoints(3000, 1.0, 0.1);
  const int depth = 4;
  const auto grid = bravais::CellGrid::CreateRound(GetBox(points), depth);
  std::vector<std::uint32_t> codes;
  for (const glm::dvec3& point : points)
  {
    codes.push_back(grid->GetCode(point));
  }
  const bravais::GixelOctree tree(codes, depth);
  const bravais::SphereTest sphere(glm::dvec3(0.3, -0.2, 0.5), 0.9);
  const bravais::BoxTest box({ glm::dvec3(-0.5), glm::dvec3(0.4, 0.9, 1.3) });
  const bravais::EllipsoidTest ellipsoid(
    glm::dmat3(1.0, 0.2, -0.3, 0.1, 2.0, 0.4, -0.6, 0.3, 0.7), glm::dvec3(0.1, -0.4, 0.2), 0.8);
  const bravais::PlanesTest planes({ { { 1.0, 2.0, -0.5 }, { 0.1, 0.2, 0.3 } },
    { { -0.3, 0.4, 0.5 }, { 0.0, 1.0, 0.0 } }, { { 0.1, -1.0, 0.0 }, { 0.0, -0.7, 0.0 } } });
  for (const bravais::VolumeTest* volume : { static_cast<const bravais::VolumeTest*>(&sphere),
         static_cast<const bravais::VolumeTest*>(&box),
         static_cast<const bravais::VolumeTest*>(&ellipsoid),
         static_cast<const bravais::VolumeTest*>(&planes) })
  {
    bravais::CullResult result;
    bravais::CullOctree(tree, *grid, *volume, result);
    std::set<std::uint32_t> seen(result.Partly.begin(), result.Partly.end());
    std::set<std::uint32_t> inside;
    for (const bravais::OctreeNode& node : result.Inside)
    {
      const std::uint32_t end = tree.GetFirstLeaf(node.Depth, node.Index + 1);
      for (auto leaf = tree.GetFirstLeaf(node.Depth, node.Index); leaf < end; ++leaf)
      {
        EXPECT_TRUE(inside.insert(leaf).second); // no node is below another
      }
    }
    seen.insert(inside.begin(), inside.end());
    EXPECT_EQ(bravais::CountLeaves(tree, result), seen.size());
    EXPECT_GT(inside.size(), 0U);
    EXPECT_LT(seen.size(), tree.GetLeaves().GetSize());
    for (std::uint32_t leaf = 0; leaf < tree.GetLeaves().GetSize(); ++leaf)
    {
      std::uint64_t pending = bravais::VolumeTest::AllPending;
      const bravais::Overlap overlap = volume->Classify(
        grid->GetBox(bravais::FromMorton(tree.GetLeaves().Codes[leaf]), depth), pending);
      EXPECT_EQ(overlap != bravais::Overlap::Outside, seen.count(leaf) > 0);
      EXPECT_EQ(overlap == bravais::Overlap::Inside, inside.count(leaf) > 0);
      for (auto n = tree.GetLeaves().Gixels[leaf]; n < tree.GetLeaves().Gixels[leaf + 1]; ++n)
      {
        const bool contained = volume->Contains(points[tree.GetGixels()[n]]);
        EXPECT_TRUE(!contained || seen.count(leaf));
        EXPECT_TRUE(contained || !inside.count(leaf));
      }
    }
  }
}
