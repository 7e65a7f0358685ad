// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCQuasiInterpolation.h"
#include "BCCSpectralPrefilter.h"
#include "SplineTesting.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bravais;

namespace
{

/// A polynomial with all monomials of up to a degree, and its gradient.
double EvaluatePolynomial(int degree, const glm::dvec3& p, glm::dvec3& gradient)
{
  double value = 0.0;
  gradient = glm::dvec3(0.0);
  for (int a = 0; a <= degree; ++a)
  {
    for (int b = 0; a + b <= degree; ++b)
    {
      for (int c = 0; a + b + c <= degree; ++c)
      {
        const double factor = GetCoefficient({ a, b, c });
        const auto power = [](double x, int n) { return n < 0 ? 0.0 : std::pow(x, n); };
        const glm::dvec3 q(power(p.x, a), power(p.y, b), power(p.z, c));
        value += factor * q.x * q.y * q.z;
        gradient += factor *
          glm::dvec3(a * power(p.x, a - 1) * q.y * q.z, q.x * b * power(p.y, b - 1) * q.z,
            q.x * q.y * c * power(p.z, c - 1));
      }
    }
  }
  return value;
}

/// The largest error of a quasi-interpolated polynomial and of its gradient where no stencil and
/// no prefilter reaches beyond the box. The polynomial's argument is within -1 .. 1.
double GetPolynomialError(BCCKernel kernel, int degree)
{
  const BCCLattice lattice({ 8, 8, 16 });
  const BCCExtent extent = { 0, 7, 0, 7, 0, 15 };
  const auto toUnit = [](const glm::dvec3& p) { return (p - 7.5) / 7.5; };
  std::vector<double> samples;
  glm::dvec3 gradient;
  for (int n = 0; n < lattice.GetNumberOfPoints(); ++n)
  {
    const glm::dvec3 p(BCCLattice::ToPoint({ n % 8, n / 8 % 8, n / 64 }));
    samples.push_back(EvaluatePolynomial(degree, toUnit(p), gradient));
  }
  std::vector<double> coefficients(samples.size());
  const bool done = QuasiInterpolate<double, double>(kernel, extent,
    BCCBlock<const double>(samples.data(), extent), BCCBlock<double>(coefficients.data(), extent));
  EXPECT_TRUE(done);
  const auto fetch = [&](const glm::ivec3& p)
  { return coefficients[static_cast<std::size_t>(lattice.ToLinearMirrored(p))]; };
  double error = 0.0;
  for (const glm::dvec3& offset : MakePoints(300, 2.4))
  {
    const glm::dvec3 p = 7.5 + offset;
    glm::dvec3 expected;
    const double value = EvaluateBoxSpline(kernel, fetch, p, gradient);
    error = std::max(error, std::abs(value - EvaluatePolynomial(degree, toUnit(p), expected)));
    error = std::max(error, glm::length(7.5 * gradient - expected));
  }
  return error;
}

/// The root mean square of the error of a smooth function, sampled with this spacing.
double GetSmoothError(BCCKernel kernel, double spacing)
{
  const auto function = [&](const glm::dvec3& p)
  {
    return std::sin(p.x * spacing + 0.4) * std::exp(std::cos(p.y * spacing)) *
      std::cos(p.z * spacing);
  };
  const BCCQuasiInterpolant prefilter = GetQuasiInterpolant(kernel);
  const auto fetch = [&](const glm::ivec3& j)
  {
    double neighbors = 0.0;
    for (const glm::ivec3& step : BCCLattice::Shell1)
    {
      neighbors += function(glm::dvec3(j + step));
    }
    return prefilter.Center * function(glm::dvec3(j)) + prefilter.Neighbor * neighbors;
  };
  double sum = 0.0;
  const auto points = MakePoints(400, 3.0);
  for (const glm::dvec3& world : points)
  {
    const glm::dvec3 p = world / spacing;
    glm::dvec3 gradient;
    const double error = EvaluateBoxSpline(kernel, fetch, p, gradient) - function(p);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

} // namespace

TEST(TestBoxSplineAccuracy, CubicsAreReproduced)
{
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC8, BCCKernel::BCC12 })
  {
    EXPECT_LT(GetPolynomialError(kernel, 3), 1e-13) << GetName(kernel);
    EXPECT_GT(GetPolynomialError(kernel, 4), 1e-4) << GetName(kernel) << " has order 4";
  }
}

TEST(TestBoxSplineAccuracy, LinearFunctionsAreReproducedByTheLinearSpline)
{
  EXPECT_LT(GetPolynomialError(BCCKernel::BCC4, 1), 1e-13);
  EXPECT_GT(GetPolynomialError(BCCKernel::BCC4, 2), 1e-4);
}

TEST(TestBoxSplineAccuracy, ErrorFallsWithTheFourthPowerOfTheSpacing)
{
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC8, BCCKernel::BCC12 })
  {
    EXPECT_NEAR(GetSmoothError(kernel, 0.1) / GetSmoothError(kernel, 0.05), 16.0, 0.5)
      << GetName(kernel);
  }
}

TEST(TestBoxSplineAccuracy, ErrorOfTheLinearSplineFallsWithTheSquareOfTheSpacing)
{
  EXPECT_NEAR(
    GetSmoothError(BCCKernel::BCC4, 0.1) / GetSmoothError(BCCKernel::BCC4, 0.05), 4.0, 0.2);
}

TEST(TestBoxSplineAccuracy, InterpolationPassesThroughTheSamples)
{
  const BCCLattice lattice({ 5, 4, 7 });
  const BCCExtent extent = { 0, 4, 0, 3, 0, 6 };
  for (const BCCKernel kernel : { BCCKernel::BCC4, BCCKernel::BCC8 })
  {
    std::vector<double> samples;
    for (int n = 0; n < lattice.GetNumberOfPoints(); ++n)
    {
      samples.push_back(GetCoefficient({ n, 0, 0 }));
    }
    auto values = samples;
    ASSERT_TRUE(ApplySpectralPrefilter(
      kernel, BCCPrefilter::Interpolation, BCCBlock<double>(values.data(), extent)));
    const auto fetch = [&](const glm::ivec3& p)
    { return values[static_cast<std::size_t>(lattice.ToLinearMirrored(p))]; };
    for (int n = 0; n < lattice.GetNumberOfPoints(); ++n)
    {
      const glm::dvec3 p(BCCLattice::ToPoint({ n % 5, n / 5 % 4, n / 20 }));
      glm::dvec3 gradient;
      EXPECT_NEAR(
        EvaluateBoxSpline(kernel, fetch, p, gradient), samples[static_cast<std::size_t>(n)], 1e-14)
        << GetName(kernel);
    }
  }
}
