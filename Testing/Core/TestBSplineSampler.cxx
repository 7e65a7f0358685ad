// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BSplineSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace bravais;

namespace
{

/// The centred B-spline by its recursion.
double BSpline(int degree, double x)
{
  if (degree == 0)
  {
    return x >= -0.5 && x < 0.5 ? 1.0 : 0.0;
  }
  const double half = 0.5 * (degree + 1);
  return ((half + x) * BSpline(degree - 1, x + 0.5) + (half - x) * BSpline(degree - 1, x - 0.5)) /
    degree;
}

int Continue(int n, int count, BSplineBorder border)
{
  while (n < 0 || n >= count)
  {
    switch (border)
    {
      case BSplineBorder::Clamp:
        n = std::clamp(n, 0, count - 1);
        break;
      case BSplineBorder::Repeat:
        n += n < 0 ? count : -count;
        break;
      case BSplineBorder::Mirror:
        n = count == 1 ? 0 : n < 0 ? -n : 2 * (count - 1) - n;
        break;
    }
  }
  return n;
}

const BSplineBorder Borders[] = { BSplineBorder::Clamp, BSplineBorder::Repeat,
  BSplineBorder::Mirror };

std::vector<float> MakeNoise(int count)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  std::vector<float> noise(count);
  std::generate(noise.begin(), noise.end(), [&] { return uniform(generator); });
  return noise;
}

}

TEST(TestBSplineAxis, HasTheSplinesWeights)
{
  for (int degree = 0; degree <= 9; ++degree)
  {
    for (const BSplineBorder border : Borders)
    {
      for (const int count : { 1, 2, 5, 30 })
      {
        const double start = -0.3;
        const double step = 0.137;
        const BSplineAxis axis(degree, border, count, start, step, 2, 2 + count * 7);
        ASSERT_EQ(axis.GetNumberOfTaps(), degree + 1);
        ASSERT_EQ(axis.GetNumberOfPositions(), count * 7 + 1);
        for (int n = 0; n < axis.GetNumberOfPositions(); ++n)
        {
          std::vector<double> weights(count, 0.0);
          std::vector<double> expected(count, 0.0);
          for (int t = 0; t <= degree; ++t)
          {
            weights.at(axis.GetIndices(n)[t]) += axis.GetWeights(n)[t];
          }
          const double x = start + step * (n + 2);
          for (int k = -12; k < count + 12; ++k)
          {
            expected[Continue(k, count, border)] += BSpline(degree, x - k);
          }
          for (int k = 0; k < count; ++k)
          {
            ASSERT_NEAR(weights[k], expected[k], 1e-14);
          }
        }
      }
    }
  }
}

TEST(TestBSplineSampler, IsTheTensorProductInAnyOrder)
{
  const glm::ivec3 n(5, 6, 7);
  const int stride = 3;
  const int components = 2;
  const std::vector<float> coefficients = MakeNoise(n.x * n.y * n.z * stride);
  const BSplineAxis x(3, BSplineBorder::Mirror, n.x, -0.2, 0.4, 0, 10);
  const BSplineAxis y(2, BSplineBorder::Clamp, n.y, 2.2, 0.3, 1, 6);
  const BSplineAxis z(4, BSplineBorder::Repeat, n.z, 0.7, 0.9, 0, 7);
  BSplineSampler<float> sampler(coefficients.data() + 1, n, stride, components, { &x, &y, &z });
  for (const int k : { 0, 1, 2, 7, 3, 3, 0, 6, 5 })
  {
    const std::vector<double>& layer = sampler.Evaluate(k);
    ASSERT_EQ(layer.size(), 11u * 6u * 2u);
    for (int p = 0; p < 11 * 6 * components; ++p)
    {
      const int c = p % components;
      const int i = p / components % 11;
      const int j = p / components / 11;
      double sum = 0.0;
      for (int tz = 0; tz < 5; ++tz)
      {
        for (int ty = 0; ty < 3; ++ty)
        {
          for (int tx = 0; tx < 4; ++tx)
          {
            const int at =
              x.GetIndices(i)[tx] + n.x * (y.GetIndices(j)[ty] + n.y * z.GetIndices(k)[tz]);
            sum += x.GetWeights(i)[tx] * y.GetWeights(j)[ty] * z.GetWeights(k)[tz] *
              coefficients[at * stride + 1 + c];
          }
        }
      }
      ASSERT_NEAR(layer[p], sum, 1e-14);
    }
  }
}
