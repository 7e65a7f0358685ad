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

/// Random numbers, each line larger than the one before.
std::vector<LineNumbers> MakeLines(std::int64_t size)
{
  std::mt19937 generator(static_cast<unsigned>(size));
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<LineNumbers> lines(static_cast<std::size_t>(size));
  for (LineNumbers& numbers : lines)
  {
    for (int line = 0; line < 8; ++line)
    {
      numbers.Values[line] = (line + 1) * uniform(generator);
    }
  }
  return lines;
}

} // namespace

TEST(TestMirrorTransform, FollowsTheDefinition)
{
  for (const int last :
    { 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 14, 22, 31, 32, 43, 49, 58, 77, 94, 127, 255 })
  {
    const MirrorTransform transform(last);
    for (int coset = 0; coset < 2; ++coset)
    {
      const std::int64_t count = transform.GetNumberOfSamples(coset);
      ASSERT_EQ(count, last / 2 + (coset == 0 || last % 2 == 1 ? 1 : 0));
      const std::vector<LineNumbers> lines = MakeLines(transform.GetBufferSize());
      std::vector<LineNumbers> spectra = lines;
      transform.Forward(coset, spectra.data());
      for (int m = 0; m < count; ++m)
      {
        for (int line = 0; line < 8; ++line)
        {
          double sum = 0.0;
          for (int x = coset; x < 2 * last; x += 2)
          {
            const int mirrored = x <= last ? x : 2 * last - x;
            sum += lines[static_cast<std::size_t>(mirrored / 2)].Values[line] *
              std::cos(Pi * m * x / last);
          }
          ASSERT_NEAR(spectra[static_cast<std::size_t>(m)].Values[line], sum, 5e-14 * last)
            << last << ' ' << coset << ' ' << m << ' ' << line;
        }
      }
      transform.Inverse(coset, spectra.data());
      for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
      {
        for (int line = 0; line < 8; ++line)
        {
          ASSERT_NEAR(spectra[n].Values[line] / static_cast<double>(transform.GetScale()),
            lines[n].Values[line], 5e-14)
            << last << ' ' << coset << ' ' << n << ' ' << line;
        }
      }
    }
  }
}

TEST(TestMirrorTransform, IsAccurateForLongPrimeLines)
{
  const MirrorTransform transform(4001);
  const std::vector<LineNumbers> lines = MakeLines(transform.GetBufferSize());
  std::vector<LineNumbers> copy = lines;
  transform.Forward(1, copy.data());
  transform.Inverse(1, copy.data());
  for (std::size_t n = 0; n < 2001; ++n)
  {
    ASSERT_NEAR(copy[n].Values[7] / 4001.0, lines[n].Values[7], 1e-12);
  }
}
