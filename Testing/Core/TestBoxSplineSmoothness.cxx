// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SplineTesting.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace bravais;

namespace
{

using Real = long double;
using Vector = glm::vec<3, Real>;

Real Fetch(const glm::ivec3& p)
{
  return GetCoefficient(p);
}

/// a + b e with e e = 0: a number and its derivative.
struct Dual
{
  Dual() = default;
  explicit Dual(double value, double derivative = 0.0)
    : Value(value)
    , Derivative(derivative)
  {
  }

  double Value = 0.0;
  double Derivative = 0.0;
};

Dual operator+(const Dual& a, const Dual& b)
{
  return Dual(a.Value + b.Value, a.Derivative + b.Derivative);
}

Dual operator-(const Dual& a, const Dual& b)
{
  return Dual(a.Value - b.Value, a.Derivative - b.Derivative);
}

Dual operator*(const Dual& a, const Dual& b)
{
  return Dual(a.Value * b.Value, a.Derivative * b.Value + a.Value * b.Derivative);
}

/// Compares a polynomial's gradient with its derivative by dual numbers.
template <class Polynomial>
void ExpectGradientIsDerivative(const Polynomial& polynomial)
{
  Dual c[32];
  for (int n = 0; n < 32; ++n)
  {
    c[n] = Dual(GetCoefficient({ n, 0, 0 }));
  }
  for (const glm::dvec3& p : MakePoints(50, 1.0))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Dual x[3] = { Dual(p.x, axis == 0), Dual(p.y, axis == 1), Dual(p.z, axis == 2) };
      Dual g[3];
      const Dual value = polynomial(x[0], x[1], x[2], c, g[0], g[1], g[2]);
      EXPECT_NEAR(g[axis].Value, value.Derivative, 1e-13);
    }
  }
}

/// A spline's gradient at a point of a face of the reference tetrahedron, and the gradient's first
/// and second derivative along the normal, as the limit from one side: there it is a polynomial of
/// degree 8 at most, found from its values at nine places.
std::array<Vector, 3> GetLimits(BCCKernel kernel, const Vector& p, const Vector& normal)
{
  constexpr int Count = 9;
  const Real step = 0.02L;
  // Newton's divided differences at the places (n + 1) step, then the polynomial in powers.
  std::array<Vector, Count> differences;
  for (int n = 0; n < Count; ++n)
  {
    EvaluateBoxSpline<Real>(kernel, Fetch, p + Real(n + 1) * step * normal, differences[n]);
  }
  for (int level = 1; level < Count; ++level)
  {
    for (int n = Count - 1; n >= level; --n)
    {
      differences[n] = (differences[n] - differences[n - 1]) / (Real(level) * step);
    }
  }
  std::array<Vector, 3> limits = { Vector(0), Vector(0), Vector(0) };
  for (int n = Count - 1; n >= 0; --n)
  {
    // Horner's rule: times (t - place), plus the difference, at t = 0.
    const Real place = Real(n + 1) * step;
    limits[2] = Real(2) * limits[1] - place * limits[2];
    limits[1] = limits[0] - place * limits[1];
    limits[0] = differences[n] - place * limits[0];
  }
  return limits;
}

/// The largest jump of a spline's gradient, and of the gradient's derivatives, over the faces.
std::array<Real, 3> GetJumps(BCCKernel kernel)
{
  const std::pair<Vector, Vector> faces[] = {
    { Vector(1.0L, 0.63L, 0.3L), Vector(1, 0, 0) },
    { Vector(0.6L, 0.6L, 0.26L), Vector(0.7L, -0.7L, 0) },
    { Vector(0.75L, 0.375L, 0.375L), Vector(0, 0.7L, -0.7L) },
    { Vector(0.7L, 0.34L, 0.0L), Vector(0, 0, 1) },
  };
  std::array<Real, 3> jumps = { 0, 0, 0 };
  for (const auto& [p, normal] : faces)
  {
    const auto before = GetLimits(kernel, p, -normal);
    auto after = GetLimits(kernel, p, normal);
    after[1] = -after[1];
    for (int n = 0; n < 3; ++n)
    {
      jumps[n] = std::max(jumps[n], glm::length(after[n] - before[n]));
    }
  }
  return jumps;
}

} // namespace

TEST(TestBoxSplineSmoothness, GradientOfThePolynomialsIsTheirDerivative)
{
  ExpectGradientIsDerivative(BCC4Polynomial<Dual>);
  ExpectGradientIsDerivative(BCC7Polynomial<Dual>);
  ExpectGradientIsDerivative(BCC8Polynomial<Dual>);
}

TEST(TestBoxSplineSmoothness, GradientIsTheDerivative)
{
  const Real h = 1e-4L;
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& center : MakePoints(200, 20.0))
    {
      const Vector p(center);
      const auto evaluate = [&](const Vector& q)
      {
        Vector gradient;
        return EvaluateBoxSpline<Real>(kernel, Fetch, q, gradient);
      };
      const Vector x = FindBCCFrame(p).Point;
      if (std::min({ 1 - x.x, x.x - x.y, x.y - x.z, x.z }) < 4 * h)
      {
        continue; // too near a knot plane
      }
      Vector gradient;
      EvaluateBoxSpline<Real>(kernel, Fetch, p, gradient);
      for (int axis = 0; axis < 3; ++axis)
      {
        Vector d(0);
        d[axis] = h;
        const Real difference = (Real(8) * (evaluate(p + d) - evaluate(p - d)) -
                                  (evaluate(p + Real(2) * d) - evaluate(p - Real(2) * d))) /
          (12 * h);
        EXPECT_NEAR(gradient[axis], difference, 1e-13) << GetName(kernel);
      }
    }
  }
}

TEST(TestBoxSplineSmoothness, ValuesAreContinuous)
{
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakeKnotPoints(300, 10.0))
    {
      glm::dvec3 gradient;
      const double value = EvaluateBoxSpline(kernel, GetCoefficient, p, gradient);
      for (const glm::dvec3& side : MakePoints(20, 1e-13))
      {
        EXPECT_NEAR(EvaluateBoxSpline(kernel, GetCoefficient, p + side, gradient), value, 1e-12)
          << GetName(kernel);
      }
    }
  }
}

TEST(TestBoxSplineSmoothness, SecondDerivativesAreContinuous)
{
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC8, BCCKernel::BCC12 })
  {
    const auto jumps = GetJumps(kernel);
    EXPECT_LT(jumps[0], 1e-13) << GetName(kernel);
    EXPECT_LT(jumps[1], 1e-10) << GetName(kernel);
    EXPECT_GT(jumps[2], 1e-2) << GetName(kernel) << " has knots";
  }
}

TEST(TestBoxSplineSmoothness, LinearSplineHasKinks)
{
  EXPECT_GT(GetJumps(BCCKernel::BCC4)[0], 1e-2);
}

TEST(TestBoxSplineSmoothness, GradientsAreContinuousAtAllKnots)
{
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC8, BCCKernel::BCC12 })
  {
    for (const glm::dvec3& p : MakeKnotPoints(300, 10.0))
    {
      glm::dvec3 gradient;
      EvaluateBoxSpline(kernel, GetCoefficient, p, gradient);
      for (const glm::dvec3& side : MakePoints(20, 1e-13))
      {
        glm::dvec3 other;
        EvaluateBoxSpline(kernel, GetCoefficient, p + side, other);
        EXPECT_LT(glm::length(other - gradient), 1e-12) << GetName(kernel);
      }
    }
  }
}
