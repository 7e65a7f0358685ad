// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

using namespace bravais;
using Base = BayerPattern::Base;
using Numbers = std::vector<std::int64_t>;

namespace
{

struct Family
{
  int Dimension;
  Base Order;
};

constexpr std::array<Family, 3> Families = { { { 2, Base::FCC }, { 3, Base::FCC },
  { 3, Base::BCC } } };

BayerPattern Make(const Family& family, int log2Size)
{
  return *BayerPattern::Create(family.Dimension, log2Size, family.Order);
}

/// Cells of the base order, as the digits xyz.
std::vector<int> GetBaseCells(Base base)
{
  const BayerPattern pattern = *BayerPattern::Create(3, 1, base);
  std::vector<int> cells;
  for (int rank = 0; rank < 8; ++rank)
  {
    const glm::ivec3 cell = pattern.GetCell(rank);
    cells.push_back(100 * cell.x + 10 * cell.y + cell.z);
  }
  return cells;
}

} // namespace

TEST(TestBayerPattern, ThresholdsAreTheLiteratures)
{
  EXPECT_EQ(GetThresholds(*BayerPattern::Create(2, 0)), (Numbers{ 0 }));
  EXPECT_EQ(GetThresholds(*BayerPattern::Create(2, 1)), (Numbers{ 0, 2, 3, 1 }));
  EXPECT_EQ(GetThresholds(*BayerPattern::Create(2, 2)),
    (Numbers{ 0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5 }));
  EXPECT_EQ(GetThresholds(*BayerPattern::Create(2, 3)),
    (Numbers{ 0, 32, 8, 40, 2, 34, 10, 42, //
      48, 16, 56, 24, 50, 18, 58, 26,      //
      12, 44, 4, 36, 14, 46, 6, 38,        //
      60, 28, 52, 20, 62, 30, 54, 22,      //
      3, 35, 11, 43, 1, 33, 9, 41,         //
      51, 19, 59, 27, 49, 17, 57, 25,      //
      15, 47, 7, 39, 13, 45, 5, 37,        //
      63, 31, 55, 23, 61, 29, 53, 21 }));
}

TEST(TestBayerPattern, OrderOfFourByFourIsTheInverse)
{
  EXPECT_EQ(GetOrder(*BayerPattern::Create(2, 2)),
    (Numbers{ 0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12 }));
}

TEST(TestBayerPattern, BaseOrdersOfTheCube)
{
  EXPECT_EQ(GetBaseCells(Base::FCC), (std::vector<int>{ 0, 110, 101, 11, 111, 1, 10, 100 }));
  EXPECT_EQ(GetBaseCells(Base::BCC), (std::vector<int>{ 0, 111, 110, 1, 101, 10, 11, 100 }));
}

TEST(TestBayerPattern, IsAPermutationAndItsInverse)
{
  for (const Family& family : Families)
  {
    for (int log2Size = 0; log2Size <= 12 / family.Dimension; ++log2Size)
    {
      const BayerPattern pattern = Make(family, log2Size);
      const Numbers thresholds = GetThresholds(pattern);
      const Numbers order = GetOrder(pattern);
      ASSERT_EQ(static_cast<std::int64_t>(thresholds.size()), pattern.GetNumberOfCells());
      Numbers sorted = thresholds;
      std::sort(sorted.begin(), sorted.end());
      Numbers all(thresholds.size());
      std::iota(all.begin(), all.end(), 0);
      EXPECT_EQ(sorted, all);
      for (const std::int64_t rank : all)
      {
        ASSERT_EQ(thresholds[order[rank]], rank);
        const glm::ivec3 cell = pattern.GetCell(rank);
        ASSERT_EQ(pattern.ToLinear(cell), order[rank]);
        ASSERT_EQ(pattern.GetRank(cell), rank);
      }
    }
  }
}

// The definition, against which the closed form is held.
TEST(TestBayerPattern, DoublesByCopiesThatTakeTurns)
{
  for (const Family& family : Families)
  {
    const BayerPattern base = Make(family, 1);
    for (int log2Size = 0; log2Size < 4; ++log2Size)
    {
      const BayerPattern half = Make(family, log2Size);
      const BayerPattern whole = Make(family, log2Size + 1);
      const int size = static_cast<int>(half.GetSize());
      for (std::int64_t rank = 0; rank < half.GetNumberOfCells(); ++rank)
      {
        const glm::ivec3 cell = half.GetCell(rank);
        for (std::int64_t turn = 0; turn < base.GetNumberOfCells(); ++turn)
        {
          ASSERT_EQ(
            whole.GetRank(cell + size * base.GetCell(turn)), base.GetNumberOfCells() * rank + turn);
        }
      }
    }
  }
}

TEST(TestBayerPattern, PrefixesArePerfectSublattices)
{
  for (const Family& family : Families)
  {
    constexpr int log2Size = 4;
    const BayerPattern pattern = Make(family, log2Size);
    for (int level = 0; level <= log2Size; ++level)
    {
      const int spacing = 1 << (log2Size - level);
      const std::int64_t prefix = std::int64_t{ 1 } << (family.Dimension * level);
      for (std::int64_t first = 0; first < pattern.GetNumberOfCells(); first += prefix)
      {
        const glm::ivec3 shift = pattern.GetCell(first);
        for (std::int64_t rank = first; rank < first + prefix; ++rank)
        {
          const glm::ivec3 rest = (pattern.GetCell(rank) - shift) % spacing;
          ASSERT_EQ(rest, glm::ivec3(0)) << rank << " of " << prefix;
        }
      }
    }
  }
}

TEST(TestBayerPattern, IsPeriodicAndLinear)
{
  for (const Family& family : Families)
  {
    const BayerPattern pattern = Make(family, 3);
    for (int x = -20; x < 20; ++x)
    {
      for (int y = -20; y < 20; ++y)
      {
        const glm::ivec3 cell(x, y, x + 3 * y);
        EXPECT_EQ(pattern.GetRank(cell), pattern.GetRank(cell & 7));
        EXPECT_EQ(pattern.GetRank(cell),
          pattern.GetRank({ cell.x, 0, 0 }) ^ pattern.GetRank({ 0, cell.y, cell.z }));
      }
    }
  }
}

TEST(TestBayerPattern, RefusesWhatIsNoPattern)
{
  EXPECT_FALSE(BayerPattern::Create(1, 2));
  EXPECT_FALSE(BayerPattern::Create(4, 2));
  EXPECT_FALSE(BayerPattern::Create(2, -1));
  EXPECT_FALSE(BayerPattern::Create(2, 30));
  EXPECT_FALSE(BayerPattern::Create(3, 21));
  EXPECT_FALSE(BayerPattern::Create(3, 2147483647));
}

TEST(TestBayerPattern, LargestRanksFit)
{
  for (const Family& family : Families)
  {
    const BayerPattern pattern = Make(family, BayerPattern::GetMaximumLog2Size(family.Dimension));
    for (const std::int64_t rank : { std::int64_t{ 12345 }, pattern.GetNumberOfCells() - 1 })
    {
      EXPECT_EQ(pattern.GetRank(pattern.GetCell(rank)), rank);
    }
  }
}
