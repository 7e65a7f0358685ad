// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace bravais;
using Base = BayerPattern::Base;

namespace
{

std::vector<BayerPattern> MakePatterns()
{
  return { *BayerPattern::Create(2, 0), *BayerPattern::Create(2, 1), *BayerPattern::Create(2, 3),
    *BayerPattern::Create(3, 0), *BayerPattern::Create(3, 2, Base::FCC),
    *BayerPattern::Create(3, 2, Base::BCC) };
}

std::int64_t GetSquaredDistance(const glm::ivec3& a, const glm::ivec3& b, int size)
{
  std::int64_t sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int way = std::abs(a[axis] - b[axis]);
    const int shorter = std::min(way, size - way);
    sum += shorter * shorter;
  }
  return sum;
}

/// Power of the first m cells by the definition.
double GetPower(const BayerPattern& pattern, std::int64_t m, const glm::ivec3& frequency)
{
  const double turn = 2.0 * std::acos(-1.0) / static_cast<double>(pattern.GetSize());
  const auto cells = static_cast<double>(pattern.GetNumberOfCells());
  std::complex<double> sum;
  for (std::int64_t rank = 0; rank < pattern.GetNumberOfCells(); ++rank)
  {
    const glm::ivec3 cell = pattern.GetCell(rank);
    const double phase =
      turn * (frequency.x * cell.x + frequency.y * cell.y + frequency.z * cell.z);
    sum += ((rank < m ? 1.0 : 0.0) - static_cast<double>(m) / cells) * std::polar(1.0, -phase);
  }
  return std::norm(sum) / cells;
}

/// Power of the prefixes of all numbers at the frequencies up to half a cycle a cell side, the
/// lowest that the base order changes.
double GetLowFrequencyPower(Base base)
{
  const BayerPattern pattern = *BayerPattern::Create(3, 1, base);
  double sum = 0.0;
  for (std::int64_t m = 1; m < 8; ++m)
  {
    const std::vector<double> power = GetPrefixSpectrum(pattern, m);
    sum += power[1] + power[2] + power[4];
  }
  return sum;
}

} // namespace

TEST(TestBayerMeasures, DistancesAreTheSmallestOfAllPairs)
{
  for (const BayerPattern& pattern : MakePatterns())
  {
    const std::vector<std::int64_t> distances = GetSquaredMinimumDistances(pattern);
    ASSERT_EQ(static_cast<std::int64_t>(distances.size()), pattern.GetNumberOfCells());
    const int size = static_cast<int>(pattern.GetSize());
    std::int64_t smallest = std::int64_t{ size } * size;
    for (std::int64_t rank = 0; rank < pattern.GetNumberOfCells(); ++rank)
    {
      for (std::int64_t earlier = 0; earlier < rank; ++earlier)
      {
        smallest = std::min(
          smallest, GetSquaredDistance(pattern.GetCell(rank), pattern.GetCell(earlier), size));
      }
      ASSERT_EQ(distances[rank], smallest) << rank;
    }
  }
}

TEST(TestBayerMeasures, DistancesOfTheBaseOrders)
{
  using Numbers = std::vector<std::int64_t>;
  const auto get = [](int dimension, Base base)
  { return GetSquaredMinimumDistances(*BayerPattern::Create(dimension, 1, base)); };
  EXPECT_EQ(get(2, Base::FCC), (Numbers{ 4, 2, 1, 1 }));
  EXPECT_EQ(get(3, Base::FCC), (Numbers{ 4, 2, 2, 2, 1, 1, 1, 1 }));
  EXPECT_EQ(get(3, Base::BCC), (Numbers{ 4, 3, 1, 1, 1, 1, 1, 1 }));
}

// Between the powers of 8 the prefixes of every size repeat the base order's distances, scaled.
TEST(TestBayerMeasures, DistancesScaleWithTheSublattices)
{
  for (const Base base : { Base::FCC, Base::BCC })
  {
    const auto small = GetSquaredMinimumDistances(*BayerPattern::Create(3, 1, base));
    const auto large = GetSquaredMinimumDistances(*BayerPattern::Create(3, 4, base));
    for (int level = 0; level < 4; ++level)
    {
      const std::int64_t lattice = std::int64_t{ 1 } << (3 * level);
      const std::int64_t scale = std::int64_t{ 1 } << (2 * (3 - level));
      for (std::int64_t copies = 1; copies <= 8; ++copies)
      {
        EXPECT_EQ(large[copies * lattice - 1], scale * small[copies - 1]);
      }
    }
  }
}

TEST(TestBayerMeasures, PrefixSpectrumIsTheDefinitions)
{
  for (const BayerPattern& pattern : MakePatterns())
  {
    const std::int64_t m = (pattern.GetNumberOfCells() + 2) / 3;
    const std::vector<double> power = GetPrefixSpectrum(pattern, m);
    for (std::int64_t rank = 0; rank < pattern.GetNumberOfCells(); ++rank)
    {
      const glm::ivec3 frequency = pattern.GetCell(rank);
      ASSERT_NEAR(power[pattern.ToLinear(frequency)], GetPower(pattern, m, frequency), 1e-12);
    }
  }
}

TEST(TestBayerMeasures, SpectraKeepThePower)
{
  for (const BayerPattern& pattern : MakePatterns())
  {
    const auto cells = static_cast<double>(pattern.GetNumberOfCells());
    double sum = 0.0;
    for (const double power : GetThresholdSpectrum(pattern))
    {
      sum += power;
    }
    // The variance of n equidistant numbers in an interval of 1.
    EXPECT_NEAR(sum, cells * (1.0 - 1.0 / (cells * cells)) / 12.0, 1e-12 * cells);
    EXPECT_NEAR(GetThresholdSpectrum(pattern)[0], 0.0, 1e-12);
  }
}

TEST(TestBayerMeasures, PerfectSublatticesHaveNoLowFrequencies)
{
  for (const Base base : { Base::FCC, Base::BCC })
  {
    const BayerPattern pattern = *BayerPattern::Create(3, 3, base);
    const std::vector<double> power = GetPrefixSpectrum(pattern, 64); // of spacing 2
    for (std::int64_t cell = 1; cell < 512; ++cell)
    {
      const bool harmonic = (cell & 3) == 0 && ((cell >> 3) & 3) == 0 && ((cell >> 6) & 3) == 0;
      EXPECT_NEAR(power[cell], harmonic ? 8.0 : 0.0, 1e-12);
    }
  }
}

TEST(TestBayerMeasures, BaseOrdersDifferInLowFrequencyPower)
{
  EXPECT_NEAR(GetLowFrequencyPower(Base::FCC), 20.0 / 8.0, 1e-12);
  EXPECT_NEAR(GetLowFrequencyPower(Base::BCC), 12.0 / 8.0, 1e-12);
}

// No order of the cube's eight cells has less power at the lowest frequencies than BCC.
TEST(TestBayerMeasures, NoOrderHasLessLowFrequencyPowerThanBCC)
{
  std::vector<int> cells = { 0, 1, 2, 3, 4, 5, 6, 7 }; // x + 2 y + 4 z
  double smallest = 1e9;
  do
  {
    double power = 0.0;
    std::array<int, 3> sums = { 0, 0, 0 };
    for (int m = 1; m < 8; ++m)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sums[axis] += ((cells[m - 1] >> axis) & 1) ? -1 : 1;
        power += sums[axis] * sums[axis] / 8.0;
      }
    }
    smallest = std::min(smallest, power);
  } while (std::next_permutation(cells.begin() + 1, cells.end()));
  EXPECT_NEAR(GetLowFrequencyPower(Base::BCC), smallest, 1e-12);
}
