// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerFill.h"
#include "BayerPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

using bravais::BayerPattern;
using bravais::GetNearestFirstCells;

TEST(TestBayerFill, StepsLeadToTheNearestFirstCell)
{
  for (int log2Size = 0; log2Size <= 3; ++log2Size)
  {
    const BayerPattern pattern = *BayerPattern::Create(2, log2Size);
    const int size = 1 << log2Size;
    for (std::int64_t count = 1; count <= pattern.GetNumberOfCells(); ++count)
    {
      const auto steps = GetNearestFirstCells(pattern, count);
      ASSERT_EQ(steps.size(), static_cast<std::size_t>(size * size));
      for (int cell = 0; cell < size * size; ++cell)
      {
        const int x = cell % size;
        const int y = cell / size;
        const glm::ivec2 step = steps[static_cast<std::size_t>(cell)];
        EXPECT_LT(pattern.GetRank({ x + step.x, y + step.y, 0 }), count);

        // Nothing nearer, of all cells within a side.
        int nearest = 2 * size * size;
        for (int dy = -size; dy <= size; ++dy)
        {
          for (int dx = -size; dx <= size; ++dx)
          {
            if (pattern.GetRank({ x + dx, y + dy, 0 }) < count)
            {
              nearest = std::min(nearest, dx * dx + dy * dy);
            }
          }
        }
        EXPECT_EQ(step.x * step.x + step.y * step.y, nearest)
          << size << " " << count << " " << cell;
      }
    }
  }
}

TEST(TestBayerFill, FirstCellsKeepTheirOwn)
{
  const BayerPattern pattern = *BayerPattern::Create(2, 3);
  const auto steps = GetNearestFirstCells(pattern, 21);
  for (std::int64_t rank = 0; rank < 21; ++rank)
  {
    const auto place = static_cast<std::size_t>(pattern.ToLinear(pattern.GetCell(rank)));
    EXPECT_EQ(steps[place], glm::ivec2(0));
  }
}

TEST(TestBayerFill, AmongEqualsOneInTheSameSquare)
{
  // Of a square of side 4 only the cell (0, 0): x = 2 is as far from it as from the next square's.
  const auto steps = GetNearestFirstCells(*BayerPattern::Create(2, 2), 1);
  EXPECT_EQ(steps[2], glm::ivec2(-2, 0));
  EXPECT_EQ(steps[3], glm::ivec2(1, 0));
  EXPECT_EQ(steps[10], glm::ivec2(-2, -2));
}
