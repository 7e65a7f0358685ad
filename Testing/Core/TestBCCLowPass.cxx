// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCLowPass.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace bravais;

namespace
{

template <class T>
void Filter(const glm::ivec3& n, const glm::dvec3& step, std::vector<T>& samples)
{
  const BCCLowPass lowPass(n, step);
  for (int pass = 0; pass < BCCLowPass::NumberOfPasses; ++pass)
  {
    for (int part = lowPass.GetNumberOfParts(pass); part-- > 0;) // in whatever order
    {
      lowPass.Apply(pass, part, samples.data());
    }
  }
}

template <class T>
std::vector<T> MakeNoise(const glm::ivec3& n)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<T> samples(n.x * n.y * n.z);
  for (T& s : samples)
  {
    s = static_cast<T>(uniform(generator));
  }
  return samples;
}

/// One line by the definition of the cosine series, weighed with any function of its index.
template <class F>
void FilterLine(std::vector<double>& samples, int first, int stride, int count, const F& weight)
{
  std::vector<double> result(count, 0.0);
  const double period = 2.0 * (count - 1);
  for (int m = 0; m < count; ++m)
  {
    double sum = 0.0;
    for (int x = 0; x < count; ++x)
    {
      const int twice = x == 0 || x == count - 1 ? 1 : 2;
      sum += twice * samples[first + x * stride] * std::cos(glm::two_pi<double>() * m * x / period);
    }
    const int twice = m == 0 || m == count - 1 ? 1 : 2;
    for (int x = 0; x < count; ++x)
    {
      result[x] +=
        weight(m) * twice * sum / period * std::cos(glm::two_pi<double>() * m * x / period);
    }
  }
  for (int x = 0; x < count; ++x)
  {
    samples[first + x * stride] = result[x];
  }
}

}

TEST(TestBCCLowPass, ResponseIsTheLatticesDodecahedron)
{
  for (double x = 0.0; x < 0.7; x += 0.03)
  {
    for (double y = 0.0; y <= x; y += 0.03)
    {
      for (double z = 0.0; z <= y; z += 0.03)
      {
        const double h = BCCLowPass::GetResponse({ x, y, z });
        EXPECT_GE(h, 0.0);
        EXPECT_LE(h, 1.0);
        if (x + y <= 0.4)
        {
          EXPECT_EQ(h, 1.0);
        }
        if (x + y >= 0.5)
        {
          EXPECT_EQ(h, 0.0);
        }
        EXPECT_NEAR(h, BCCLowPass::GetResponse({ -z, x, -y }), 1e-15);
        EXPECT_LE(BCCLowPass::GetResponse({ x + 0.01, y, z }), h);
      }
    }
  }
}

TEST(TestBCCLowPass, FollowsTheCosineSeriesOnOneAxis)
{
  // Samples that vary along one axis have frequencies along it alone.
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 n(5, 6, 7);
    n[axis] = 18;
    const glm::dvec3 step(0.4, 0.5, 0.6);
    std::vector<double> line = MakeNoise<double>({ 18, 1, 1 });
    std::vector<double> samples(n.x * n.y * n.z);
    const auto at = [&](int p)
    {
      const glm::ivec3 index(p % n.x, p / n.x % n.y, p / n.x / n.y);
      return line[index[axis]];
    };
    for (int p = 0; p < n.x * n.y * n.z; ++p)
    {
      samples[p] = at(p);
    }
    Filter(n, step, samples);
    FilterLine(line, 0, 1, 18,
      [&](int m) {
        return BCCLowPass::GetResponse({ m / (34.0 * step[axis]), 0.0, 0.0 });
      });
    for (int p = 0; p < n.x * n.y * n.z; ++p)
    {
      ASSERT_NEAR(samples[p], at(p), 1e-13);
    }
  }
}

TEST(TestBCCLowPass, KeepsOrRemovesEachMirroredWave)
{
  const glm::ivec3 n(12, 9, 10);
  const glm::dvec3 step(0.45, 0.6, 0.5);
  for (const glm::ivec3& m : { glm::ivec3(3, 2, 0), glm::ivec3(0, 5, 4), glm::ivec3(6, 1, 3),
         glm::ivec3(11, 8, 9), glm::ivec3(4, 3, 3), glm::ivec3(0) })
  {
    std::vector<double> samples;
    for (int p = 0; p < n.x * n.y * n.z; ++p)
    {
      const glm::dvec3 x(p % n.x, p / n.x % n.y, p / n.x / n.y);
      const glm::dvec3 phase = glm::pi<double>() * glm::dvec3(m) * x / glm::dvec3(n - 1);
      samples.push_back(std::cos(phase.x) * std::cos(phase.y) * std::cos(phase.z));
    }
    const std::vector<double> before = samples;
    Filter(n, step, samples);
    const double gain = BCCLowPass::GetResponse(glm::dvec3(m) / (2.0 * glm::dvec3(n - 1)) / step);
    for (std::size_t p = 0; p < samples.size(); ++p)
    {
      ASSERT_NEAR(samples[p], gain * before[p], 1e-13);
    }
  }
}

TEST(TestBCCLowPass, KeepsWhatACoarseGridHolds)
{
  const glm::ivec3 n(2, 17, 8);
  const std::vector<float> before = MakeNoise<float>(n);
  std::vector<float> samples = before;
  Filter(n, glm::dvec3(2.5), samples);
  for (std::size_t p = 0; p < samples.size(); ++p)
  {
    ASSERT_NEAR(samples[p], before[p], 1e-6);
  }
}
