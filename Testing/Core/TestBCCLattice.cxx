// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCLattice.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

using bravais::BCCLattice;

namespace
{
constexpr BCCLattice Box(glm::ivec3(4, 3, 7));

// Calls f(index) for each index of the box.
template <typename F>
void ForEachIndex(F&& f)
{
  const glm::ivec3 n = Box.GetDimensions();
  for (int k = 0; k < n.z; ++k)
  {
    for (int j = 0; j < n.y; ++j)
    {
      for (int i = 0; i < n.x; ++i)
      {
        f(glm::ivec3(i, j, k));
      }
    }
  }
}
}

TEST(TestBCCLattice, PointsHaveOneParityAndComeBackToTheirIndex)
{
  ForEachIndex(
    [](const glm::ivec3& index)
    {
      const glm::ivec3 point = BCCLattice::ToPoint(index);
      EXPECT_TRUE(BCCLattice::IsPoint(point));
      EXPECT_EQ(BCCLattice::ToIndex(point), index);
      EXPECT_EQ(BCCLattice::GetCoset(index.z), point.x & 1);
    });
  for (int z = -4; z <= 4; ++z)
  {
    const glm::ivec3 index(-3, -5, z);
    EXPECT_EQ(BCCLattice::ToIndex(BCCLattice::ToPoint(index)), index);
  }
  EXPECT_FALSE(BCCLattice::IsPoint({ 1, 0, 0 }));
  EXPECT_FALSE(BCCLattice::IsPoint({ 1, 1, 0 }));
  EXPECT_FALSE(BCCLattice::IsPoint({ 0, -1, 0 }));
  EXPECT_TRUE(BCCLattice::IsPoint({ -1, 3, 5 }));
}

TEST(TestBCCLattice, LinearOrderIsDense)
{
  std::int64_t expected = 0;
  ForEachIndex([&](const glm::ivec3& index) { EXPECT_EQ(Box.ToLinear(index), expected++); });
  EXPECT_EQ(Box.GetNumberOfPoints(), expected);
}

TEST(TestBCCLattice, LinearOrderIsOf64Bits)
{
  constexpr BCCLattice large(glm::ivec3(2048, 2048, 4096));
  EXPECT_EQ(large.GetNumberOfPoints(), std::int64_t{ 1 } << 34);
  EXPECT_EQ(large.ToLinear({ 2047, 2047, 4095 }), (std::int64_t{ 1 } << 34) - 1);
}

TEST(TestBCCLattice, ShellsAreTheNearestAndSecondNeighbours)
{
  std::set<std::array<int, 3>> nearest;
  std::set<std::array<int, 3>> second;
  for (int z = -3; z <= 3; ++z)
  {
    for (int y = -3; y <= 3; ++y)
    {
      for (int x = -3; x <= 3; ++x)
      {
        const int squared = x * x + y * y + z * z;
        if (BCCLattice::IsPoint({ x, y, z }) && squared > 0 && squared <= 4)
        {
          (squared == 3 ? nearest : second).insert({ x, y, z });
        }
      }
    }
  }
  std::set<std::array<int, 3>> shell1;
  for (const glm::ivec3& p : BCCLattice::Shell1)
  {
    shell1.insert({ p.x, p.y, p.z });
  }
  std::set<std::array<int, 3>> shell2;
  for (const glm::ivec3& p : BCCLattice::Shell2)
  {
    shell2.insert({ p.x, p.y, p.z });
  }
  EXPECT_EQ(shell1, nearest);
  EXPECT_EQ(shell2, second);
}

TEST(TestBCCLattice, MirrorIsTheFoldedLine)
{
  for (int last = 1; last <= 6; ++last)
  {
    for (int x = 0; x <= last; ++x)
    {
      EXPECT_EQ(BCCLattice::Mirror(x, last), x);
    }
    for (int x = -5 * last; x <= 5 * last; ++x)
    {
      EXPECT_EQ(BCCLattice::Mirror(-x, last), BCCLattice::Mirror(x, last));
      EXPECT_EQ(BCCLattice::Mirror(2 * last - x, last), BCCLattice::Mirror(x, last));
      EXPECT_EQ((BCCLattice::Mirror(x, last) - x) % 2, 0);
    }
  }
}

TEST(TestBCCLattice, MirroredPointsStayInTheirCosetAndInTheBox)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(-40, 40);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const glm::ivec3 point =
      BCCLattice::ToPoint({ number(random), number(random), number(random) });
    const glm::ivec3 mirrored = Box.Mirror(point);
    EXPECT_TRUE(BCCLattice::IsPoint(mirrored));
    EXPECT_EQ(mirrored.z & 1, point.z & 1);
    const glm::ivec3 index = BCCLattice::ToIndex(mirrored);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(index, glm::ivec3(0))));
    EXPECT_TRUE(glm::all(glm::lessThan(index, Box.GetDimensions())));
    EXPECT_EQ(Box.ToLinearMirrored(point), Box.ToLinear(index));
  }
}

TEST(TestBCCLattice, NearestPointIsNearerThanAnyOther)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-5.0, 5.0);
  for (int trial = 0; trial < 500; ++trial)
  {
    const glm::dvec3 position(number(random), number(random), number(random));
    const glm::ivec3 nearest = BCCLattice::FindNearest(position);
    ASSERT_TRUE(BCCLattice::IsPoint(nearest));
    double best = std::numeric_limits<double>::max();
    for (int z = -7; z <= 7; ++z)
    {
      for (int y = -7; y <= 7; ++y)
      {
        for (int x = -7; x <= 7; ++x)
        {
          if (BCCLattice::IsPoint({ x, y, z }))
          {
            best = std::min(best, glm::distance(position, glm::dvec3(x, y, z)));
          }
        }
      }
    }
    EXPECT_DOUBLE_EQ(glm::distance(position, glm::dvec3(nearest)), best);
  }
}

TEST(TestBCCLattice, NearestPointOfALatticePointIsItself)
{
  ForEachIndex(
    [](const glm::ivec3& index)
    {
      const glm::ivec3 point = BCCLattice::ToPoint(index) - glm::ivec3(4);
      EXPECT_EQ(BCCLattice::FindNearest(glm::dvec3(point)), point);
    });
  EXPECT_EQ(BCCLattice::FindNearest({ 0.5, 0.5, 0.5 }), glm::ivec3(0)); // a tie
}
