// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickDistances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

using namespace bravais;

namespace
{

glm::ivec3 Locate(int n, const glm::ivec3& size)
{
  return { n % size.x, n / size.x % size.y, n / (size.x * size.y) };
}

int Measure(const glm::ivec3& a, const glm::ivec3& b)
{
  return std::max({ std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z) });
}

} // namespace

TEST(TestBrickDistances, AreTheSmallestToAllMarks)
{
  std::mt19937 random(1);
  const glm::ivec3 sizes[] = { { 9, 8, 7 }, { 1, 1, 1 }, { 20, 1, 1 }, { 1, 13, 2 }, { 2, 3, 30 } };
  for (const glm::ivec3& size : sizes)
  {
    const int count = size.x * size.y * size.z;
    for (const int share : { 2, 10, 200 })
    {
      std::vector<std::uint8_t> bricks(static_cast<std::size_t>(count));
      std::generate(bricks.begin(), bricks.end(),
        [&] { return static_cast<std::uint8_t>(random() % static_cast<unsigned>(share) == 0); });
      const std::vector<std::uint8_t> marks = bricks;
      FindBrickDistances(size, bricks);
      for (int n = 0; n < count; ++n)
      {
        int expected = 255;
        for (int m = 0; m < count; ++m)
        {
          if (marks[static_cast<std::size_t>(m)])
          {
            expected = std::min(expected, Measure(Locate(n, size), Locate(m, size)));
          }
        }
        ASSERT_EQ(bricks[static_cast<std::size_t>(n)], expected);
      }
    }
  }
}

TEST(TestBrickDistances, EndAt255)
{
  std::vector<std::uint8_t> bricks(400);
  bricks[0] = 7;
  FindBrickDistances({ 1, 400, 1 }, bricks);
  for (std::size_t n = 0; n < bricks.size(); ++n)
  {
    ASSERT_EQ(bricks[n], std::min<std::size_t>(n, 255));
  }
}

TEST(TestBrickDistances, WithSignsTellOfMarkedBricksToo)
{
  std::mt19937 random(2);
  const glm::ivec3 size(9, 8, 7);
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(size.x * size.y * size.z));
  std::generate(
    marks.begin(), marks.end(), [&] { return static_cast<std::uint8_t>(random() % 7 != 0); });
  std::vector<std::uint8_t> signs = marks;
  FindSignedBrickDistances(size, signs);
  std::vector<std::uint8_t> others = marks;
  std::transform(others.begin(), others.end(), others.begin(),
    [](std::uint8_t mark) { return static_cast<std::uint8_t>(!mark); });
  FindBrickDistances(size, marks);
  FindBrickDistances(size, others);
  for (std::size_t n = 0; n < signs.size(); ++n)
  {
    ASSERT_EQ(signs[n], 128 + marks[n] - others[n]);
  }
}

TEST(TestBrickDistances, WithSignsEndAtAByte)
{
  std::vector<std::uint8_t> bricks(400);
  FindSignedBrickDistances({ 1, 400, 1 }, bricks);
  EXPECT_EQ(bricks, std::vector<std::uint8_t>(400, 255));
  bricks.assign(400, 3);
  FindSignedBrickDistances({ 400, 1, 1 }, bricks);
  EXPECT_EQ(bricks, std::vector<std::uint8_t>(400, 0));
}
