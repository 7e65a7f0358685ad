// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCSpectralPrefilter.h"

#include "BCCLattice.h"
#include "ReferenceBCCSpectrum.h"

#include <gtest/gtest.h>

#include <complex>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

using namespace bravais;

namespace
{

BCCExtent MakeExtent(const glm::ivec3& dimensions, int firstLayer = 0)
{
  return { 0, dimensions.x - 1, 0, dimensions.y - 1, firstLayer, firstLayer + dimensions.z - 1 };
}

template <class R = double>
std::vector<R> MakeSamples(std::int64_t count)
{
  std::mt19937 generator(static_cast<unsigned>(count));
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<R> samples(static_cast<std::size_t>(count));
  for (R& sample : samples)
  {
    sample = static_cast<R>(uniform(generator));
  }
  return samples;
}

std::vector<double> Filter(BCCKernel kernel, BCCPrefilter prefilter, const glm::ivec3& dimensions,
  std::vector<double> values, int firstLayer = 0)
{
  const BCCBlock<double> block(values.data(), MakeExtent(dimensions, firstLayer));
  EXPECT_TRUE(ApplySpectralPrefilter(kernel, prefilter, block));
  return values;
}

double GetLargest(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// The prefilter by its definition: the discrete Fourier transform of the continued samples over
/// the lattice points of one period, times Q at each frequency.
std::vector<double> FilterBySum(BCCKernel kernel, BCCPrefilter prefilter,
  const glm::ivec3& dimensions, const std::vector<double>& samples)
{
  const BCCLattice lattice(dimensions);
  const glm::ivec3 period = 2 * lattice.GetLast();
  const int count = period.x * period.y * period.z;
  const auto at = [&](int n)
  { return glm::ivec3(n % period.x, n / period.x % period.y, n / (period.x * period.y)); };
  std::vector<double> coefficients(samples.size());
  for (int n = 0; n < count; ++n)
  {
    const glm::dvec3 w = 2.0 * ReferencePi * glm::dvec3(at(n)) / glm::dvec3(period);
    std::complex<double> spectrum;
    for (int m = 0; m < count; ++m)
    {
      if (BCCLattice::IsPoint(at(m)))
      {
        spectrum += samples[static_cast<std::size_t>(lattice.ToLinearMirrored(at(m)))] *
          std::polar(1.0, -glm::dot(w, glm::dvec3(at(m))));
      }
    }
    spectrum *= ReferenceResponse(kernel, prefilter, w) / count;
    for (std::size_t c = 0; c < samples.size(); ++c)
    {
      const int i = static_cast<int>(c);
      const glm::ivec3 index(
        i % dimensions.x, i / dimensions.x % dimensions.y, i / (dimensions.x * dimensions.y));
      coefficients[c] +=
        (spectrum * std::polar(1.0, glm::dot(w, glm::dvec3(BCCLattice::ToPoint(index))))).real();
    }
  }
  return coefficients;
}

const glm::ivec3 SmallDimensions[] = { { 3, 4, 5 }, { 2, 2, 2 }, { 1, 1, 2 }, { 3, 1, 6 },
  { 1, 2, 3 }, { 2, 3, 4 } };

constexpr BCCPrefilter Prefilters[] = { BCCPrefilter::Interpolation, BCCPrefilter::Projection };

template <class F>
void ForEachPrefilter(F&& function)
{
  for (const BCCKernel kernel : ReferenceKernels)
  {
    for (const BCCPrefilter prefilter : Prefilters)
    {
      if (IsDefined(kernel, prefilter))
      {
        SCOPED_TRACE(std::string(GetName(kernel)) + ' ' + GetName(prefilter));
        function(kernel, prefilter);
      }
    }
  }
}

} // namespace

TEST(TestBCCSpectralPrefilter, EqualsTheSumOverAPeriod)
{
  ForEachPrefilter(
    [](BCCKernel kernel, BCCPrefilter prefilter)
    {
      // At some of these frequencies BCC12's Projection is nearly singular.
      const double tolerance = kernel == BCCKernel::BCC12 ? 1e-10 : 1e-13;
      for (const glm::ivec3& dimensions : SmallDimensions)
      {
        const auto samples = MakeSamples(BCCLattice(dimensions).GetNumberOfPoints());
        const auto expected = FilterBySum(kernel, prefilter, dimensions, samples);
        const auto coefficients = Filter(kernel, prefilter, dimensions, samples);
        for (std::size_t n = 0; n < samples.size(); ++n)
        {
          ASSERT_NEAR(coefficients[n], expected[n], tolerance * GetLargest(expected))
            << dimensions.x << ' ' << dimensions.y << ' ' << dimensions.z;
        }
      }
    });
}

TEST(TestBCCSpectralPrefilter, StartsAtAnOddLayer)
{
  // Layers 1, 2, .. are layers 0, 1, .. with x and y turned round.
  const glm::ivec3 dimensions(3, 4, 5);
  const BCCLattice lattice(dimensions);
  const auto turn = [&](const std::vector<double>& values)
  {
    std::vector<double> turned(values.size());
    for (int n = 0; n < 60; ++n)
    {
      turned[static_cast<std::size_t>(lattice.ToLinear({ 2 - n % 3, 3 - n / 3 % 4, n / 12 }))] =
        values[static_cast<std::size_t>(n)];
    }
    return turned;
  };
  ForEachPrefilter(
    [&](BCCKernel kernel, BCCPrefilter prefilter)
    {
      const auto samples = MakeSamples(60);
      const auto expected = turn(Filter(kernel, prefilter, dimensions, samples));
      const auto coefficients = Filter(kernel, prefilter, dimensions, turn(samples), -3);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        ASSERT_NEAR(coefficients[n], expected[n], 1e-13 * GetLargest(expected));
      }
    });
}

TEST(TestBCCSpectralPrefilter, InterpolationPassesThroughTheSamples)
{
  for (const BCCKernel kernel : { BCCKernel::BCC4, BCCKernel::BCC8 })
  {
    const auto table = GetReferenceTable(kernel, BCCPrefilter::Interpolation);
    for (const glm::ivec3& dimensions : { glm::ivec3(13, 7, 10), glm::ivec3(1, 1, 2),
           glm::ivec3(5, 19, 9), glm::ivec3(33, 2, 12), glm::ivec3(1, 1, 23) })
    {
      const BCCLattice lattice(dimensions);
      const auto samples = MakeSamples(lattice.GetNumberOfPoints());
      const auto coefficients = Filter(kernel, BCCPrefilter::Interpolation, dimensions, samples);
      std::vector<double> spline(samples.size());
      for (int n = 0; n < static_cast<int>(samples.size()); ++n)
      {
        const glm::ivec3 point = BCCLattice::ToPoint(
          { n % dimensions.x, n / dimensions.x % dimensions.y, n / (dimensions.x * dimensions.y) });
        ForEachReferencePoint(table,
          [&](const glm::ivec3& offset, double value)
          {
            spline[static_cast<std::size_t>(n)] += value *
              coefficients[static_cast<std::size_t>(lattice.ToLinearMirrored(point + offset))];
          });
      }
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        ASSERT_NEAR(spline[n], samples[n], 1e-14) << GetName(kernel) << ' ' << dimensions.x;
      }
    }
  }
}

TEST(TestBCCSpectralPrefilter, PreservesConstants)
{
  ForEachPrefilter(
    [](BCCKernel kernel, BCCPrefilter prefilter)
    {
      for (const glm::ivec3& dimensions : SmallDimensions)
      {
        const std::vector<double> samples(BCCLattice(dimensions).GetNumberOfPoints(), 0.7);
        for (const double c : Filter(kernel, prefilter, dimensions, samples))
        {
          ASSERT_NEAR(c, 0.7, 1e-12);
        }
      }
    });
}

TEST(TestBCCSpectralPrefilter, LeavesOutTheAlternatingComponent)
{
  const glm::ivec3 dimensions(4, 5, 6);
  std::vector<double> samples(120);
  for (int n = 0; n < 120; ++n)
  {
    samples[static_cast<std::size_t>(n)] = 3.0 + (n / 20 % 2 == 0 ? 1.0 : -1.0);
  }
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC12 })
  {
    for (const double c : Filter(kernel, BCCPrefilter::Projection, dimensions, samples))
    {
      ASSERT_NEAR(c, 3.0, 1e-11);
    }
  }
}

TEST(TestBCCSpectralPrefilter, TreatsComponentsAlone)
{
  const glm::ivec3 dimensions(19, 5, 7);
  const int components = 3;
  const std::int64_t count = BCCLattice(dimensions).GetNumberOfPoints();
  auto all = MakeSamples<float>(count * components);
  const auto samples = all;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  all[1] = nan; // the second component of the first sample
  ASSERT_TRUE(ApplySpectralPrefilter(BCCKernel::BCC7, BCCPrefilter::Projection,
    BCCBlock<float>(all.data(), MakeExtent(dimensions), components)));
  for (int component = 0; component < components; ++component)
  {
    std::vector<float> one(static_cast<std::size_t>(count));
    for (std::size_t n = 0; n < one.size(); ++n)
    {
      one[n] = samples[n * components + component];
    }
    ASSERT_TRUE(ApplySpectralPrefilter(BCCKernel::BCC7, BCCPrefilter::Projection,
      BCCBlock<float>(one.data(), MakeExtent(dimensions))));
    for (std::size_t n = 0; n < one.size(); ++n)
    {
      const float value = all[n * components + component];
      ASSERT_TRUE(component == 1 ? std::isnan(value) : value == one[n]);
    }
  }
}

TEST(TestBCCSpectralPrefilter, HonoursStrides)
{
  const glm::ivec3 dimensions(5, 3, 4);
  const auto samples = MakeSamples(60);
  const auto dense = Filter(BCCKernel::BCC8, BCCPrefilter::Interpolation, dimensions, samples);
  std::vector<double> spread(7 * 4 * 4, -7.0);
  BCCBlock<double> block(spread.data(), MakeExtent(dimensions));
  block.RowStride = 7;
  block.LayerStride = 28;
  for (int row = 0; row < 12; ++row)
  {
    std::copy_n(samples.begin() + 5 * row, 5, block.GetRow(row % 3, row / 3));
  }
  ASSERT_TRUE(ApplySpectralPrefilter(BCCKernel::BCC8, BCCPrefilter::Interpolation, block));
  for (int n = 0; n < 112; ++n)
  {
    const bool inside = n % 7 < 5 && n / 7 % 4 < 3;
    const int row = n / 28 * 3 + n / 7 % 4;
    ASSERT_EQ(spread[static_cast<std::size_t>(n)],
      inside ? dense[static_cast<std::size_t>(5 * row + n % 7)] : -7.0);
  }
}

TEST(TestBCCSpectralPrefilter, DoesNotDependOnThreads)
{
  const glm::ivec3 dimensions(35, 18, 21);
  const auto samples = MakeSamples<float>(BCCLattice(dimensions).GetNumberOfPoints());
  const auto run = [&](const ParallelFor& parallelFor)
  {
    auto values = samples;
    EXPECT_TRUE(ApplySpectralPrefilter(BCCKernel::BCC7, BCCPrefilter::Projection,
      BCCBlock<float>(values.data(), MakeExtent(dimensions)), parallelFor));
    return values;
  };
  const auto serial = run({});
  const auto threaded = run(
    [](std::int64_t begin, std::int64_t end, const auto& body)
    {
      std::vector<std::thread> threads;
      for (std::int64_t n = begin; n < end; ++n)
      {
        threads.emplace_back(body, n, n + 1);
      }
      for (std::thread& thread : threads)
      {
        thread.join();
      }
    });
  ASSERT_EQ(std::memcmp(serial.data(), threaded.data(), serial.size() * sizeof(float)), 0);
}

TEST(TestBCCSpectralPrefilter, ReportsProgressAndStops)
{
  const glm::ivec3 dimensions(8, 8, 16);
  std::vector<double> values(1024, 1.0);
  const BCCBlock<double> block(values.data(), MakeExtent(dimensions));
  std::vector<double> reports;
  ASSERT_TRUE(ApplySpectralPrefilter(BCCKernel::BCC7, BCCPrefilter::Projection, block, {},
    [&](double done)
    {
      reports.push_back(done);
      return true;
    }));
  ASSERT_GE(reports.size(), 10u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GE(reports.front(), 0.0);
  EXPECT_LE(reports.back(), 1.0);

  std::size_t calls = 0;
  EXPECT_FALSE(ApplySpectralPrefilter(
    BCCKernel::BCC7, BCCPrefilter::Projection, block, {}, [&](double) { return ++calls < 4; }));
  EXPECT_EQ(calls, 4u);
}

TEST(TestBCCSpectralPrefilter, RefusesWhatItCannotDo)
{
  const auto samples = MakeSamples(64);
  auto values = samples;
  const auto run =
    [&](BCCKernel kernel, BCCPrefilter prefilter, const BCCExtent& extent, int components)
  {
    return ApplySpectralPrefilter(
      kernel, prefilter, BCCBlock<double>(values.data(), extent, components));
  };
  const BCCExtent good = { 0, 3, 0, 3, 0, 3 };
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::Interpolation, good, 1));
  EXPECT_FALSE(run(BCCKernel::BCC12, BCCPrefilter::Interpolation, good, 1));
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::None, good, 1));
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::QuasiInterpolation, good, 1));
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::Projection, { 0, 3, 0, 3, 2, 2 }, 1));
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::Projection, { 0, -1, 0, 3, 0, 3 }, 1));
  EXPECT_FALSE(run(BCCKernel::BCC7, BCCPrefilter::Projection, good, 0));
  EXPECT_EQ(values, samples);
}
