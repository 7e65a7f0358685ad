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
