// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MirrorTransform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace bravais;

namespace
{

constexpr double Pi = 3.14159265358979323846;
using Complex = MirrorTransform::Complex;

std::vector<Complex> MakeLine(std::int64_t count)
{
  std::mt19937 generator(static_cast<unsigned>(count));
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Complex> line(count);
  for (Complex& value : line)
  {
    value = { uniform(generator), uniform(generator) };
  }
  return line;
}

} // namespace

TEST(TestMirrorTransform, FollowsTheDefinition)
{
  for (const int last : { 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 14, 22, 31, 49, 58, 77, 94, 127 })
  {
    const MirrorTransform transform(last);
    MirrorTransform::Scratch scratch = transform.MakeScratch();
    for (int coset = 0; coset < 2; ++coset)
    {
      const std::int64_t count = transform.GetNumberOfSamples(coset);
      std::int64_t samples = 0;
      for (int x = coset; x <= last; x += 2)
      {
        ++samples;
      }
      ASSERT_EQ(count, samples);
      const std::vector<Complex> line = MakeLine(count);
      std::vector<Complex> spectrum = line;
      transform.Forward(coset, spectrum.data(), scratch);
      for (int m = 0; m < count; ++m)
      {
        Complex sum;
        for (int x = coset; x < 2 * last; x += 2)
        {
          sum += line[(x <= last ? x : 2 * last - x) / 2] * std::cos(Pi * m * x / last);
        }
        ASSERT_LT(std::abs(spectrum[m] - sum), 1e-14 * last) << last << ' ' << coset << ' ' << m;
      }
      transform.Inverse(coset, spectrum.data(), scratch);
      for (int n = 0; n < count; ++n)
      {
        ASSERT_LT(std::abs(spectrum[n] / double(transform.GetScale()) - line[n]), 1e-14)
          << last << ' ' << coset << ' ' << n;
      }
    }
  }
}

TEST(TestMirrorTransform, IsAccurateForLongPrimeLines)
{
  const int last = 4001;
  const MirrorTransform transform(last);
  MirrorTransform::Scratch scratch = transform.MakeScratch();
  const std::vector<Complex> line = MakeLine(transform.GetNumberOfSamples(1));
  std::vector<Complex> copy = line;
  transform.Forward(1, copy.data(), scratch);
  transform.Inverse(1, copy.data(), scratch);
  for (std::size_t n = 0; n < line.size(); ++n)
  {
    ASSERT_LT(std::abs(copy[n] / double(last) - line[n]), 1e-13);
  }
}
