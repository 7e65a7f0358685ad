// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCLattice.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSpectralPrefilter.h"
#include "BoxSpline.h"
#include "ReferenceBCCSpectrum.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace bravais;

namespace
{

BCCExtent MakeExtent(const glm::ivec3& dimensions)
{
  return { 0, dimensions.x - 1, 0, dimensions.y - 1, 0, dimensions.z - 1 };
}

/// Samples of a function of lattice coordinates.
template <class R, class F>
std::vector<R> Sample(const glm::ivec3& dimensions, F&& function)
{
  std::vector<R> samples;
  for (int k = 0; k < dimensions.z; ++k)
  {
    for (int j = 0; j < dimensions.y; ++j)
    {
      for (int i = 0; i < dimensions.x; ++i)
      {
        samples.push_back(static_cast<R>(function(glm::dvec3(BCCLattice::ToPoint({ i, j, k })))));
      }
    }
  }
  return samples;
}

template <class R>
void ApplyPrefilter(
  BCCKernel kernel, BCCPrefilter prefilter, const glm::ivec3& dimensions, std::vector<R>& values)
{
  const BCCExtent extent = MakeExtent(dimensions);
  const std::vector<R> samples = values;
  const BCCBlock<R> block(values.data(), extent);
  if (prefilter == BCCPrefilter::QuasiInterpolation)
  {
    ASSERT_TRUE(
      (QuasiInterpolate<R, R>(kernel, extent, BCCBlock<const R>(samples.data(), extent), block)));
  }
  else if (prefilter != BCCPrefilter::None)
  {
    ASSERT_TRUE(ApplySpectralPrefilter(kernel, prefilter, block));
  }
}

/// The test signal of Marschner and Lobb on [-1, 1]^3.
double MarschnerLobb(const glm::dvec3& x)
{
  const double r = std::sqrt(x.x * x.x + x.y * x.y);
  const double wave = std::cos(12.0 * ReferencePi * std::cos(0.5 * ReferencePi * r));
  return (1.0 - std::sin(0.5 * ReferencePi * x.z) + 0.25 * (1.0 + wave)) / 2.5;
}

/// The root mean square of the spline's error at random points with coordinates within 0.6.
template <class R>
double GetError(BCCKernel kernel, BCCPrefilter prefilter)
{
  const glm::ivec3 dimensions(39, 39, 78);
  const auto toWorld = [](const glm::dvec3& p) { return p * (2.0 / 77.0) - 1.0; };
  auto values =
    Sample<R>(dimensions, [&](const glm::dvec3& p) { return MarschnerLobb(toWorld(p)); });
  ApplyPrefilter(kernel, prefilter, dimensions, values);
  const BCCLattice lattice(dimensions);
  const auto fetch = [&](const glm::ivec3& p)
  { return values[static_cast<std::size_t>(lattice.ToLinearMirrored(p))]; };
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.2 * 77.0, 0.8 * 77.0);
  double sum = 0.0;
  const int count = 30000;
  for (int n = 0; n < count; ++n)
  {
    const glm::vec<3, R> p(uniform(generator), uniform(generator), uniform(generator));
    glm::vec<3, R> gradient;
    const double error =
      EvaluateBoxSpline(kernel, fetch, p, gradient) - MarschnerLobb(toWorld(glm::dvec3(p)));
    sum += error * error;
  }
  return std::sqrt(sum / count);
}

/// Gauss quadrature of splines over the box 0 .. last, exact for products of degree 13:
/// the tetrahedra of the knot planes are images of 1 >= x >= y >= z >= 0.
template <class F>
void ForEachQuadraturePoint(const glm::ivec3& last, F&& function)
{
  constexpr double Nodes[] = { 0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
    0.9602898564975363 };
  constexpr double Weights[] = { 0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
    0.1012285362903763 };
  const auto node = [&](int n) { return 0.5 + (n < 4 ? 0.5 : -0.5) * Nodes[n % 4]; };
  const auto weight = [&](int n) { return 0.5 * Weights[n % 4]; };
  for (int cell = 0; cell < last.x * last.y * last.z; ++cell)
  {
    const glm::ivec3 low(cell % last.x, cell / last.x % last.y, cell / (last.x * last.y));
    const glm::ivec3 parity = low & glm::ivec3(1);
    for (int n = 0; n < 8 * 8 * 8; ++n)
    {
      const double x = node(n % 8);
      const double y = x * node(n / 8 % 8);
      const double z = y * node(n / 64);
      const double w = weight(n % 8) * weight(n / 8 % 8) * weight(n / 64) * x * y;
      for (const glm::dvec3& p : { glm::dvec3(x, y, z), glm::dvec3(y, z, x), glm::dvec3(z, x, y),
             glm::dvec3(x, z, y), glm::dvec3(z, y, x), glm::dvec3(y, x, z) })
      {
        function(glm::dvec3(low + parity) + glm::dvec3(1 - 2 * parity) * p, w);
      }
    }
  }
}

} // namespace

TEST(TestBCCPrefilterAccuracy, MarschnerLobb)
{
  // Cartesian tri-cubic interpolation of as many samples has 0.0020, trilinear 0.0170.
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC4, BCCPrefilter::None), 0.0145, 3e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC7, BCCPrefilter::None), 0.0229, 3e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC8, BCCPrefilter::None), 0.0228, 3e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC12, BCCPrefilter::None), 0.0370, 3e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC4, BCCPrefilter::Projection), 0.0088, 2e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC7, BCCPrefilter::QuasiInterpolation), 0.0092, 2e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC7, BCCPrefilter::Projection), 0.00125, 5e-5);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC8, BCCPrefilter::QuasiInterpolation), 0.0091, 2e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC8, BCCPrefilter::Interpolation), 0.0020, 1e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC8, BCCPrefilter::Projection), 0.00127, 5e-5);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC12, BCCPrefilter::QuasiInterpolation), 0.0199, 4e-4);
  EXPECT_NEAR(GetError<double>(BCCKernel::BCC12, BCCPrefilter::Projection), 0.00033, 2e-5);
}

TEST(TestBCCPrefilterAccuracy, FloatIsEnough)
{
  EXPECT_NEAR(GetError<float>(BCCKernel::BCC7, BCCPrefilter::Projection), 0.00125, 5e-5);
  EXPECT_NEAR(GetError<float>(BCCKernel::BCC12, BCCPrefilter::Projection), 0.00033, 2e-5);
}

TEST(TestBCCPrefilterAccuracy, ProjectionIsOrthogonal)
{
  // Waves of the mirrored box that are within the lattice's band.
  const glm::ivec3 dimensions(1, 2, 3);
  const auto signal = [](const glm::dvec3& p)
  {
    const double wy = ReferencePi / 3.0 * p.y;
    const double wz = ReferencePi / 2.0 * p.z;
    return 0.3 + std::cos(wy) - 0.4 * std::cos(wz) - 0.1 * std::cos(wy) * std::cos(wz) +
      0.7 * std::cos(2.0 * wy);
  };
  const BCCLattice lattice(dimensions);
  const auto samples = Sample<double>(dimensions, signal);
  for (const BCCKernel kernel : ReferenceKernels)
  {
    auto coefficients = samples;
    ApplyPrefilter(kernel, BCCPrefilter::Projection, dimensions, coefficients);
    // The integrals of the difference from the signal times each of the basis functions.
    std::vector<double> products(samples.size());
    ForEachQuadraturePoint(lattice.GetLast(),
      [&](const glm::dvec3& p, double weight)
      {
        glm::dvec3 gradient;
        const auto evaluate = [&](const std::vector<double>& values)
        {
          const auto fetch = [&](const glm::ivec3& q)
          { return values[static_cast<std::size_t>(lattice.ToLinearMirrored(q))]; };
          return EvaluateBoxSpline(kernel, fetch, p, gradient);
        };
        const double difference = signal(p) - evaluate(coefficients);
        std::vector<double> basis(samples.size());
        for (std::size_t n = 0; n < basis.size(); ++n)
        {
          basis[n] = 1.0;
          products[n] += weight * difference * evaluate(basis);
          basis[n] = 0.0;
        }
      });
    for (const double product : products)
    {
      EXPECT_NEAR(product, 0.0, 1e-12) << GetName(kernel);
    }
  }
}
