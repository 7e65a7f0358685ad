// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCQuasiInterpolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

using namespace bravais;

namespace
{

std::size_t Count(const BCCExtent& e)
{
  return static_cast<std::size_t>(e[1] - e[0] + 1) * (e[3] - e[2] + 1) * (e[5] - e[4] + 1);
}

template <class T>
std::vector<T> MakeRandom(std::size_t count, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> uniform(0, 100);
  std::vector<T> values(count);
  for (T& v : values)
  {
    v = static_cast<T>(uniform(generator) / (std::is_integral_v<T> ? 1 : 7.0));
  }
  return values;
}

/// Reflects x at a and b until it lies between them.
int Mirror(int x, int a, int b)
{
  while (x < a || x > b)
  {
    x = x < a ? 2 * a - x : 2 * b - x;
  }
  return x;
}

/// The prefilter from its definition, in lattice coordinates.
template <class T>
double Expected(BCCKernel kernel, const BCCExtent& w, const std::vector<T>& f, int step, int c,
  int i, int j, int k)
{
  const auto sample = [&](int x, int y, int z)
  {
    z = Mirror(z, w[4], w[5]);
    const int a = (Mirror(x, 2 * w[0], 2 * w[1] + 1) - (z & 1)) / 2 - w[0];
    const int b = (Mirror(y, 2 * w[2], 2 * w[3] + 1) - (z & 1)) / 2 - w[2];
    const std::size_t row = static_cast<std::size_t>(z - w[4]) * (w[3] - w[2] + 1) + b;
    return static_cast<double>(f[(row * (w[1] - w[0] + 1) + a) * step + c]);
  };
  const int x = 2 * i + (k & 1);
  const int y = 2 * j + (k & 1);
  double sum = 0.0;
  for (int s = 0; s < 8; ++s)
  {
    sum += sample(x + ((s & 1) ? 1 : -1), y + ((s & 2) ? 1 : -1), k + ((s & 4) ? 1 : -1));
  }
  const BCCQuasiInterpolant q = GetQuasiInterpolant(kernel);
  return q.Center * sample(x, y, k) + q.Neighbor * sum;
}

template <class T, class R>
std::vector<R> Filter(BCCKernel kernel, const BCCExtent& whole, const std::vector<T>& samples,
  const BCCExtent& extent, int components = 1)
{
  std::vector<R> coefficients(Count(extent) * components);
  const BCCBlock<const T> in(samples.data(), whole, components);
  const BCCBlock<R> out(coefficients.data(), extent, components);
  EXPECT_TRUE((QuasiInterpolate<T, R>(kernel, whole, in, out)));
  return coefficients;
}

const BCCKernel Kernels[] = { BCCKernel::BCC4, BCCKernel::BCC7, BCCKernel::BCC8, BCCKernel::BCC12 };

const BCCExtent Wholes[] = { { 0, 4, 0, 6, 0, 7 }, { -3, 2, 5, 8, -3, 3 }, { 0, 0, 0, 0, 0, 1 },
  { 2, 3, 0, 0, 1, 2 } };

template <class T>
class TestBCCQuasiInterpolationTypes : public testing::Test
{
};
using ScalarTypes = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(TestBCCQuasiInterpolationTypes, ScalarTypes);

}

TYPED_TEST(TestBCCQuasiInterpolationTypes, FollowsTheDefinitionUpToTheMirror)
{
  using R = BCCCoefficient<TypeParam>;
  for (const BCCExtent& w : Wholes)
  {
    for (const BCCKernel kernel : Kernels)
    {
      const int step = 3;
      const auto samples = MakeRandom<TypeParam>(Count(w) * step, 1);
      const auto coefficients = Filter<TypeParam, R>(kernel, w, samples, w, step);
      const BCCBlock<const R> block(coefficients.data(), w, step);
      for (int k = w[4]; k <= w[5]; ++k)
      {
        for (int j = w[2]; j <= w[3]; ++j)
        {
          for (int p = 0; p < (w[1] - w[0] + 1) * step; ++p)
          {
            ASSERT_NEAR(block.GetRow(j, k)[p],
              Expected(kernel, w, samples, step, p % step, w[0] + p / step, j, k),
              2000 * std::numeric_limits<R>::epsilon());
          }
        }
      }
    }
  }
}

TEST(TestBCCQuasiInterpolation, PreservesConstants)
{
  const BCCExtent& w = Wholes[1];
  for (const BCCKernel kernel : Kernels)
  {
    for (const double c : Filter<double, double>(kernel, w, std::vector<double>(Count(w), 0.7), w))
    {
      ASSERT_NEAR(c, 0.7, 1e-15);
    }
  }
}

TEST(TestBCCQuasiInterpolation, PiecesEqualTheWholeBitForBit)
{
  const BCCExtent w = { -1, 21, 3, 9, -2, 5 };
  const int step = 2;
  const auto samples = MakeRandom<float>(Count(w) * step, 2);
  const BCCBlock<const float> in(samples.data(), w, step);
  for (const BCCKernel kernel : Kernels)
  {
    const auto all = Filter<float, float>(kernel, w, samples, w, step);
    const BCCBlock<const float> allBlock(all.data(), w, step);
    for (const BCCExtent& e : { BCCExtent{ -1, 21, 3, 9, -1, 5 }, BCCExtent{ -1, 3, 3, 4, 0, 0 },
           BCCExtent{ 5, 21, 9, 9, 5, 5 }, BCCExtent{ 4, 13, 5, 7, 1, 2 },
           BCCExtent{ 7, 7, 6, 6, -2, -2 } })
    {
      // The needed samples alone, so that reading others would be out of bounds.
      const BCCExtent grown = GrowWithin(w, e);
      std::vector<float> part(Count(grown) * step);
      const BCCBlock<float> partBlock(part.data(), grown, step);
      for (int k = grown[4]; k <= grown[5]; ++k)
      {
        for (int j = grown[2]; j <= grown[3]; ++j)
        {
          std::copy_n(in.GetRow(j, k) + (grown[0] - w[0]) * step, partBlock.RowStride,
            partBlock.GetRow(j, k));
        }
      }
      std::vector<float> piece(Count(e) * step);
      const BCCBlock<float> out(piece.data(), e, step);
      ASSERT_TRUE((QuasiInterpolate<float, float>(
        kernel, w, BCCBlock<const float>(part.data(), grown, step), out)));
      for (int k = e[4]; k <= e[5]; ++k)
      {
        for (int j = e[2]; j <= e[3]; ++j)
        {
          ASSERT_EQ(std::memcmp(out.GetRow(j, k), allBlock.GetRow(j, k) + (e[0] - w[0]) * step,
                      out.RowStride * sizeof(float)),
            0);
        }
      }
    }
  }
}

TEST(TestBCCQuasiInterpolation, HonoursStrides)
{
  const BCCExtent w = { 0, 4, 0, 2, 0, 3 };
  const auto samples = MakeRandom<short>(Count(w), 3);
  const auto dense = Filter<short, float>(BCCKernel::BCC8, w, samples, w);
  std::vector<short> spread(8 * 3 * 5, -1);
  BCCBlock<short> in(spread.data(), w);
  in.RowStride = 8;
  in.LayerStride = 30;
  std::vector<float> result(7 * 3 * 4, -1.0f);
  BCCBlock<float> out(result.data(), w);
  out.RowStride = 7;
  out.LayerStride = 21;
  const BCCBlock<const short> source(samples.data(), w);
  for (int row = 0; row < 12; ++row)
  {
    std::copy_n(source.GetRow(row % 3, row / 3), 5, in.GetRow(row % 3, row / 3));
  }
  BCCBlock<const short> readable(spread.data(), w);
  readable.RowStride = in.RowStride;
  readable.LayerStride = in.LayerStride;
  ASSERT_TRUE((QuasiInterpolate<short, float>(BCCKernel::BCC8, w, readable, out)));
  for (int row = 0; row < 12; ++row)
  {
    for (int i = 0; i < 7; ++i)
    {
      EXPECT_EQ(out.GetRow(row % 3, row / 3)[i], i < 5 ? dense[row * 5 + i] : -1.0f);
    }
  }
}

TEST(TestBCCQuasiInterpolation, KeepsNaNToItsNeighbours)
{
  const BCCExtent w = { 0, 6, 0, 6, 0, 6 };
  std::vector<float> samples(Count(w), 1.0f);
  const int x = 6, y = 6, z = 4; // the sample (3, 3, 4)
  samples[3 + 7 * (3 + 7 * 4)] = std::numeric_limits<float>::quiet_NaN();
  const auto coefficients = Filter<float, float>(BCCKernel::BCC7, w, samples, w);
  for (int n = 0; n < 343; ++n)
  {
    const int k = n / 49;
    const int dx = std::abs(2 * (n % 7) + (k & 1) - x);
    const int dy = std::abs(2 * (n / 7 % 7) + (k & 1) - y);
    const int dz = std::abs(k - z);
    const bool near = (dx == 0 && dy == 0 && dz == 0) || (dx == 1 && dy == 1 && dz == 1);
    ASSERT_EQ(std::isnan(coefficients[n]), near);
  }
}

TEST(TestBCCQuasiInterpolation, RefusesWhatItCannotDo)
{
  const BCCExtent w = { 0, 4, 0, 4, 0, 4 };
  const std::vector<float> samples(125, 1.0f);
  std::vector<float> result(250, -1.0f);
  const auto run = [&](const BCCExtent& whole, const BCCExtent& in, const BCCExtent& out,
                     int inComponents, int outComponents)
  {
    return QuasiInterpolate<float, float>(BCCKernel::BCC7, whole,
      BCCBlock<const float>(samples.data(), in, inComponents),
      BCCBlock<float>(result.data(), out, outComponents));
  };
  EXPECT_FALSE(run(w, { 0, 4, 0, 4, 1, 3 }, { 0, 4, 0, 4, 1, 3 }, 1, 1)); // no layers beside
  EXPECT_FALSE(run(w, w, { 0, 5, 0, 4, 0, 4 }, 1, 1));                    // beyond the whole
  EXPECT_FALSE(run(w, w, { 0, -1, 0, 4, 0, 4 }, 1, 1));                   // empty
  EXPECT_FALSE(run(w, w, { 0, 1, 0, 1, 0, 1 }, 1, 2));                    // components differ
  EXPECT_FALSE(run(w, w, { 0, 1, 0, 1, 0, 1 }, 0, 0));                    // no component
  EXPECT_FALSE(run({ 0, 4, 0, 4, 0, 0 }, w, { 0, 4, 0, 4, 0, 0 }, 1, 1)); // one layer
  for (const float c : result)
  {
    EXPECT_EQ(c, -1.0f);
  }
}
