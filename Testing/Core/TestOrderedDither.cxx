// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OrderedDither.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace bravais;

namespace
{

/// One row by the definition, in double precision.
template <class T>
std::vector<int> Expect(const BayerPattern& pattern, int levels, double lo, double hi,
  const std::vector<T>& in, int components, int x, int y, int z)
{
  std::vector<int> out;
  for (std::size_t i = 0; i < in.size(); ++i)
  {
    const double u = (static_cast<double>(in[i]) - lo) / (hi - lo) * (levels - 1);
    const double clamped = std::fmin(std::fmax(u, 0.0), levels - 1.0);
    const glm::ivec3 cell(x + static_cast<int>(i) / components, y, z);
    const double threshold = (static_cast<double>(pattern.GetRank(cell)) + 0.5) /
      static_cast<double>(pattern.GetNumberOfCells());
    const double level = std::floor(clamped);
    out.push_back(static_cast<int>(level) + (clamped - level >= threshold ? 1 : 0));
  }
  return out;
}

template <class T>
std::vector<int> Quantize(
  const OrderedDither& dither, const std::vector<T>& in, int components, int x, int y, int z)
{
  std::vector<unsigned char> out(in.size());
  const OrderedDitherRows<T> rows(
    dither, x, static_cast<std::int64_t>(in.size()) / components, components);
  rows.Execute(in.data(), y, z, out.data());
  return { out.begin(), out.end() };
}

template <class T>
class TestOrderedDitherTypes : public testing::Test
{
};

using Types = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;

} // namespace

TYPED_TEST_SUITE(TestOrderedDitherTypes, Types);

TYPED_TEST(TestOrderedDitherTypes, RowsAreTheDefinitions)
{
  using T = TypeParam;
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> uniform(std::is_signed_v<T> ? -128 : 0, 127);
  std::vector<T> in(3 * 1500);
  for (T& value : in)
  {
    value = static_cast<T>(uniform(generator));
  }
  // 251 is a prime, so that no number lies on a threshold, where rounding would decide.
  const double lo = -100.0;
  const double hi = lo + 251.0;
  for (const int dimension : { 2, 3 })
  {
    for (const int log2Size : { 0, 1, 3, 5 })
    {
      const BayerPattern pattern = *BayerPattern::Create(dimension, log2Size);
      for (const int levels : { 2, 5, 256 })
      {
        const OrderedDither dither = *OrderedDither::Create(pattern, levels, lo, hi);
        for (const int components : { 1, 3 })
        {
          ASSERT_EQ(Quantize(dither, in, components, -5, 3, 6),
            Expect(pattern, levels, lo, hi, in, components, -5, 3, 6));
        }
      }
    }
  }
}

TEST(TestOrderedDither, ConstantsKeepTheirMeanToHalfAThreshold)
{
  for (const int dimension : { 2, 3 })
  {
    const BayerPattern pattern = *BayerPattern::Create(dimension, 2);
    for (const int levels : { 2, 3, 8, 256 })
    {
      const OrderedDither dither = *OrderedDither::Create(pattern, levels, 0.0, 1.0);
      for (int step = 0; step <= 1000; ++step)
      {
        const std::vector<double> row(4, step / 1000.0);
        double sum = 0.0;
        for (int z = 0; z < (dimension == 3 ? 4 : 1); ++z)
        {
          for (int y = 0; y < 4; ++y)
          {
            for (const int level : Quantize(dither, row, 1, 0, y, z))
            {
              sum += level;
            }
          }
        }
        const auto cells = static_cast<double>(pattern.GetNumberOfCells());
        ASSERT_NEAR(sum / cells, row[0] * (levels - 1), 0.5 / cells + 1e-9);
      }
    }
  }
}

TEST(TestOrderedDither, LevelsThemselvesStay)
{
  const OrderedDither dither = *OrderedDither::Create(*BayerPattern::Create(2, 5), 256, 0.0, 255.0);
  std::vector<unsigned char> in(256);
  std::vector<int> expected(256);
  for (int i = 0; i < 256; ++i)
  {
    in[i] = static_cast<unsigned char>(i);
    expected[i] = i;
  }
  for (int y = 0; y < 32; ++y)
  {
    EXPECT_EQ(Quantize(dither, in, 1, y, y, 0), expected);
  }
}

TEST(TestOrderedDither, NumbersBeyondTheRangeAndNaN)
{
  const OrderedDither dither = *OrderedDither::Create(*BayerPattern::Create(2, 1), 4, 0.0, 1.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> in = { -infinity, -1e300, 0.0, 1.0, 1e300, infinity, std::nan("") };
  EXPECT_EQ(Quantize(dither, in, 1, 0, 0, 0), (std::vector<int>{ 0, 0, 0, 3, 3, 3, 0 }));
  EXPECT_EQ(Quantize(dither, std::vector<float>(in.begin() + 2, in.end()), 1, 0, 0, 0),
    (std::vector<int>{ 0, 3, 3, 3, 0 }));
}

TEST(TestOrderedDither, NarrowRangesFarFromZero)
{
  const double lo = 1e6 + 0.3;
  const OrderedDither dither =
    *OrderedDither::Create(*BayerPattern::Create(2, 0), 2, lo, lo + 0.25);
  EXPECT_EQ(Quantize(dither, std::vector<float>{ 1000000.375F, 1000000.4375F }, 1, 0, 0, 0),
    (std::vector<int>{ 0, 1 }));
}

TEST(TestOrderedDither, RangesBeyondFloat)
{
  const OrderedDither dither =
    *OrderedDither::Create(*BayerPattern::Create(2, 0), 3, -1e300, 1e300);
  EXPECT_EQ(Quantize(dither, std::vector<float>{ -1e30F, 0.0F, 1e30F }, 1, 0, 0, 0),
    (std::vector<int>{ 1, 1, 1 }));
}

TEST(TestOrderedDither, LargestPattern)
{
  const BayerPattern pattern = *BayerPattern::Create(2, 11);
  const OrderedDither dither = *OrderedDither::Create(pattern, 256, 0.0, 1.0);
  const std::vector<double> in = { 0.0, 0.1, 0.5, 0.9, 1.0 };
  EXPECT_EQ(
    Quantize(dither, in, 1, 1000, 77, 0), Expect(pattern, 256, 0.0, 1.0, in, 1, 1000, 77, 0));
  const std::vector<float> ends = { 0.0F, 1.0F, 2.0F };
  EXPECT_EQ(Quantize(dither, ends, 1, 1000, 77, 0), (std::vector<int>{ 0, 255, 255 }));
}

TEST(TestOrderedDither, RefusesBadParameters)
{
  const BayerPattern pattern = *BayerPattern::Create(2, 3);
  EXPECT_FALSE(OrderedDither::Create(pattern, 1, 0.0, 1.0));
  EXPECT_FALSE(OrderedDither::Create(pattern, 257, 0.0, 1.0));
  EXPECT_FALSE(OrderedDither::Create(pattern, 2, 1.0, 1.0));
  EXPECT_FALSE(OrderedDither::Create(pattern, 2, 1.0, 0.0));
  EXPECT_FALSE(OrderedDither::Create(pattern, 2, std::nan(""), 1.0));
  EXPECT_FALSE(OrderedDither::Create(pattern, 2, -1e308, 1e308));
  EXPECT_FALSE(OrderedDither::Create(*BayerPattern::Create(2, 12), 2, 0.0, 1.0));
  EXPECT_FALSE(OrderedDither::Create(*BayerPattern::Create(3, 8), 2, 0.0, 1.0));
}
