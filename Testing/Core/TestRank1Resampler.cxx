// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Rank1Resampler.h"
#include "Rank1Search.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>

using namespace bravais;

namespace
{

std::vector<double> MakePixels(int count)
{
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> anything(-1.0, 3.0);
  std::vector<double> pixels(count);
  for (double& pixel : pixels)
  {
    pixel = anything(generator);
  }
  return pixels;
}

template <class T>
std::vector<T> Resample(const Rank1Lattice& lattice, glm::ivec2 tiles, glm::ivec2 size,
  const std::vector<T>& pixels, Rank1Filter filter, Rank1Boundary boundary)
{
  const Rank1Resampler resampler(lattice, tiles, size, filter, boundary);
  const std::int64_t n = lattice.GetNumberOfPoints();
  const int components = static_cast<int>(pixels.size() / (size.x * size.y));
  std::vector<T> texels(n * tiles.x * tiles.y * components);
  for (int y = 0; y < tiles.y; ++y)
  {
    for (int x = 0; x < tiles.x; ++x)
    {
      T* tile = texels.data() + (x + tiles.x * y) * n * components;
      const std::int64_t half = n / 2; // in two parts
      resampler.Execute(pixels.data(), components, { x, y }, 0, half, tile);
      resampler.Execute(pixels.data(), components, { x, y }, half, n, tile + half * components);
    }
  }
  return texels;
}

double GetMean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The mean over a cell by many samples, wrapped round.
double SampleCell(const Rank1Lattice& lattice, std::int64_t texel, glm::ivec2 size,
  const std::vector<double>& pixels)
{
  constexpr int side = 400;
  const glm::dvec2 center = lattice.GetPoint(texel);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const glm::dvec2 uv =
        center + glm::dvec2((x + 0.5) / side - 0.5, (y + 0.5) / side - 0.5) * 0.6;
      const glm::dvec2 p = uv - glm::floor(uv);
      if (lattice.FindNearest(p) == texel)
      {
        sum += pixels[static_cast<int>(p.x * size.x) + size.x * static_cast<int>(p.y * size.y)];
        ++count;
      }
    }
  }
  return sum / count;
}

} // namespace

TEST(TestRank1Resampler, BoxKeepsTheMean)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (const glm::ivec2 tiles : { glm::ivec2(1, 1), glm::ivec2(3, 2) })
    {
      for (const glm::ivec2 size : { glm::ivec2(40, 28), glm::ivec2(1, 1), glm::ivec2(7, 2) })
      {
        const std::vector<double> pixels = MakePixels(size.x * size.y);
        const std::vector<double> texels =
          Resample(lattice, tiles, size, pixels, Rank1Filter::Box, Rank1Boundary::Periodic);
        ASSERT_NEAR(GetMean(texels), GetMean(pixels), 1e-11);
      }
    }
  }
}

TEST(TestRank1Resampler, BoxIsTheMeanOverTheCell)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(30, 1, 7, { 3.0, 2.0 });
  const glm::ivec2 size(9, 10);
  const std::vector<double> pixels = MakePixels(90);
  const std::vector<double> texels =
    Resample(lattice, { 1, 1 }, size, pixels, Rank1Filter::Box, Rank1Boundary::Periodic);
  for (std::int64_t texel = 0; texel < 30; ++texel)
  {
    EXPECT_NEAR(texels[texel], SampleCell(lattice, texel, size, pixels), 0.03) << texel;
  }
}

TEST(TestRank1Resampler, AllFiltersKeepConstants)
{
  const Rank1Lattice lattice = *MaximizeMinimumDistance(100);
  const std::vector<double> pixels(12 * 9, 5.0);
  for (const Rank1Filter filter :
    { Rank1Filter::Box, Rank1Filter::Bilinear, Rank1Filter::Bicubic, Rank1Filter::Nearest })
  {
    for (const Rank1Boundary boundary :
      { Rank1Boundary::Periodic, Rank1Boundary::Clamp, Rank1Boundary::Mirror })
    {
      for (const double texel : Resample(lattice, { 2, 1 }, { 12, 9 }, pixels, filter, boundary))
      {
        EXPECT_NEAR(texel, 5.0, 1e-13);
      }
    }
  }
}

TEST(TestRank1Resampler, BilinearAndBicubicKeepSlopesAwayFromTheBorder)
{
  const Rank1Lattice lattice = *MaximizeMinimumDistance(200);
  const glm::ivec2 size(30, 20);
  std::vector<double> pixels;
  for (int i = 0; i < 600; ++i)
  {
    pixels.push_back(2.0 * (i % 30 + 0.5) - 3.0 * (i / 30 + 0.5));
  }
  for (const Rank1Filter filter : { Rank1Filter::Bilinear, Rank1Filter::Bicubic })
  {
    const auto texels = Resample(lattice, { 1, 1 }, size, pixels, filter, Rank1Boundary::Clamp);
    for (std::int64_t i = 0; i < 200; ++i)
    {
      const glm::dvec2 p = lattice.GetPoint(i) * glm::dvec2(size);
      if (p.x > 2.0 && p.x < 28.0 && p.y > 2.0 && p.y < 18.0)
      {
        EXPECT_NEAR(texels[i], 2.0 * p.x - 3.0 * p.y, 1e-11);
      }
    }
  }
}

TEST(TestRank1Resampler, BoundariesAreThoseOfAPictureThreeTimesTheSize)
{
  // The middle tile of a picture continued by hand is what the boundary mode makes of the picture.
  const Rank1Lattice lattice = *MaximizeMinimumDistance(40);
  const glm::ivec2 size(6, 5);
  const std::vector<double> pixels = MakePixels(30);
  for (const Rank1Boundary boundary :
    { Rank1Boundary::Periodic, Rank1Boundary::Clamp, Rank1Boundary::Mirror })
  {
    std::vector<double> large;
    for (int y = -5; y < 10; ++y)
    {
      for (int x = -6; x < 12; ++x)
      {
        glm::ivec2 p(x, y);
        for (int axis = 0; axis < 2; ++axis)
        {
          const int n = size[axis];
          const bool beyond = p[axis] < 0 || p[axis] >= n;
          switch (boundary)
          {
            case Rank1Boundary::Periodic:
              p[axis] = (p[axis] + n) % n;
              break;
            case Rank1Boundary::Clamp:
              p[axis] = std::clamp(p[axis], 0, n - 1);
              break;
            default:
              p[axis] = !beyond ? p[axis] : p[axis] < 0 ? -1 - p[axis] : 2 * n - 1 - p[axis];
          }
        }
        large.push_back(pixels[p.x + 6 * p.y]);
      }
    }
    for (const Rank1Filter filter :
      { Rank1Filter::Box, Rank1Filter::Bilinear, Rank1Filter::Bicubic, Rank1Filter::Nearest })
    {
      const auto texels = Resample(lattice, { 1, 1 }, size, pixels, filter, boundary);
      const auto nine = Resample(lattice, { 3, 3 }, 3 * size, large, filter, boundary);
      for (std::int64_t i = 0; i < 40; ++i)
      {
        EXPECT_NEAR(texels[i], nine[4 * 40 + i], 1e-12);
      }
    }
  }
}

TEST(TestRank1Resampler, ComponentsAreResampledAlike)
{
  const Rank1Lattice lattice = *MaximizeMinimumDistance(50);
  const std::vector<double> one = MakePixels(99);
  std::vector<double> three;
  for (const double pixel : one)
  {
    three.insert(three.end(), { pixel, 2.0 * pixel, -pixel });
  }
  for (const Rank1Filter filter :
    { Rank1Filter::Box, Rank1Filter::Bilinear, Rank1Filter::Bicubic, Rank1Filter::Nearest })
  {
    const auto a = Resample(lattice, { 1, 1 }, { 11, 9 }, one, filter, Rank1Boundary::Mirror);
    const auto b = Resample(lattice, { 1, 1 }, { 11, 9 }, three, filter, Rank1Boundary::Mirror);
    for (int i = 0; i < 50; ++i)
    {
      EXPECT_EQ(b[3 * i], a[i]);
      EXPECT_EQ(b[3 * i + 1], 2.0 * a[i]);
      EXPECT_EQ(b[3 * i + 2], -a[i]);
    }
  }
}

TEST(TestRank1Resampler, LargeNumbersAndNoNumbersStayWhereTheyAre)
{
  const Rank1Lattice lattice = *MaximizeMinimumDistance(64);
  std::vector<float> pixels(32 * 32, 0.25f);
  pixels[5 + 32 * 7] = std::numeric_limits<float>::infinity();
  pixels[20 + 32 * 20] = std::numeric_limits<float>::quiet_NaN();
  pixels[9 + 32 * 30] = 1e30f;
  const auto texels =
    Resample(lattice, { 1, 1 }, { 32, 32 }, pixels, Rank1Filter::Box, Rank1Boundary::Periodic);
  EXPECT_GE(std::count(texels.begin(), texels.end(), 0.25f), 64 - 12);
  EXPECT_GE(*std::max_element(texels.begin(), texels.end()), 1e28f);
}

TEST(TestRank1Resampler, IntegersAreRounded)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(2, 1, 1);
  const std::vector<unsigned char> pixels = { 254, 255, 255, 255 };
  const auto texels =
    Resample(lattice, { 1, 1 }, { 2, 2 }, pixels, Rank1Filter::Box, Rank1Boundary::Periodic);
  EXPECT_EQ(texels, (std::vector<unsigned char>{ 255, 255 }));
  const std::vector<std::int64_t> large = { (std::int64_t{ 1 } << 62) + 1 };
  EXPECT_EQ(
    Resample(lattice, { 1, 1 }, { 1, 1 }, large, Rank1Filter::Nearest, Rank1Boundary::Clamp)[1],
    large[0]);
}
