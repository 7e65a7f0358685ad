// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BoxSpline_h
#define BoxSpline_h

/// \file
/// The box-splines of the BCC lattice at one point: values and gradients from coefficients.
///
/// bcc4, bcc7 and bcc8 follow algorithm 1 of Kim and Lee, Real-time BCC Volume Isosurface Ray
/// Casting on the GPU. The knot planes of bcc7 cut space into tetrahedra that reflections and
/// permutations of the axes carry to one of them, 1 >= x >= y >= z >= 0, and each tetrahedron of
/// bcc4 and bcc8 is the union of four of these. So BCCFrame serves all three, and what is left is
/// one polynomial each, which GenerateBoxSplines.py writes. bcc12 is the tri-cubic B-spline on each
/// of the two cosets. There is no table look-up and no branch.
///
/// These are the twins of Rendering/GLSL; BCCSplineRows evaluates many points at once.

#include "BCCKernel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace bravais
{

#include "BCC4Polynomial.inl"
#include "BCC7Polynomial.inl"
#include "BCC8Polynomial.inl"

/// How a point's tetrahedron lies: the map (P_t R_p) to the reference tetrahedron, and its inverse.
template <class T>
struct BCCFrame
{
  glm::ivec3 Even;      ///< the even lattice point that is the tetrahedron's vertex (0, 0, 0)
  glm::ivec3 Odd;       ///< the odd lattice point that is its vertex (1, 1, 1)
  glm::ivec3 Steps[3];  ///< steps of 2 along the tetrahedron's axes, in lattice coordinates
  glm::vec<3, T> Point; ///< the point in the reference tetrahedron

  /// Turns a gradient along the tetrahedron's axes back to lattice coordinates (eq. 26).
  glm::vec<3, T> TurnBack(const glm::vec<3, T>& g) const
  {
    using V = glm::vec<3, T>;
    return T(0.5) * (g.x * V(this->Steps[0]) + g.y * V(this->Steps[1]) + g.z * V(this->Steps[2]));
  }
};

/// The frame of a finite point in lattice coordinates (eq. 18 to 25).
template <class T>
BCCFrame<T> FindBCCFrame(const glm::vec<3, T>& p)
{
  const glm::ivec3 low(glm::floor(p));
  const glm::ivec3 parity = low & glm::ivec3(1);
  const glm::ivec3 sign = 1 - 2 * parity;
  BCCFrame<T> frame;
  frame.Even = low + parity;
  frame.Odd = frame.Even + sign;
  const glm::vec<3, T> x = glm::vec<3, T>(sign) * (p - glm::vec<3, T>(frame.Even));
  // How many of the other coordinates go before each, in descending order.
  const glm::ivec3 rank(int(x.y > x.x) + int(x.z > x.x), int(x.x >= x.y) + int(x.z > x.y),
    int(x.x >= x.z) + int(x.y >= x.z));
  for (int n = 0; n < 3; ++n)
  {
    const glm::ivec3 axis(glm::equal(rank, glm::ivec3(n)));
    frame.Steps[n] = 2 * sign * axis;
    frame.Point[n] = glm::dot(glm::vec<3, T>(axis), x);
  }
  return frame;
}

/// Weights of the uniform cubic B-spline for the coefficients at -1, 0, 1, 2, at 0 <= t <= 1.
template <class T>
glm::vec<4, T> CubicWeights(T t)
{
  const T s = T(1) - t;
  return T(1.0 / 6.0) *
    glm::vec<4, T>(
      s * s * s, T(4) + t * t * (T(3) * t - T(6)), T(4) + s * s * (T(3) * s - T(6)), t * t * t);
}

/// The derivatives of CubicWeights.
template <class T>
glm::vec<4, T> CubicDerivativeWeights(T t)
{
  const T s = T(1) - t;
  return T(0.5) * glm::vec<4, T>(-s * s, t * (T(3) * t - T(4)), -(s * (T(3) * s - T(4))), t * t);
}

/// bcc12's part from the coset of parity 0 or 1.
template <class T, class Fetch>
T EvaluateCubicCoset(
  const Fetch& fetch, const glm::vec<3, T>& p, int parity, glm::vec<3, T>& gradient)
{
  const glm::vec<3, T> q = T(0.5) * (p - T(parity));
  const glm::vec<3, T> low = glm::floor(q);
  const glm::ivec3 first = 2 * (glm::ivec3(low) - 1) + parity;
  glm::vec<4, T> w[3];
  glm::vec<4, T> d[3];
  for (int n = 0; n < 3; ++n)
  {
    w[n] = CubicWeights(q[n] - low[n]);
    d[n] = CubicDerivativeWeights(q[n] - low[n]);
  }
  T value(0);
  gradient = glm::vec<3, T>(0);
  for (int c = 0; c < 4; ++c)
  {
    for (int b = 0; b < 4; ++b)
    {
      for (int a = 0; a < 4; ++a)
      {
        const T f = fetch(first + 2 * glm::ivec3(a, b, c));
        value += f * w[0][a] * w[1][b] * w[2][c];
        gradient += f *
          glm::vec<3, T>(
            d[0][a] * w[1][b] * w[2][c], w[0][a] * d[1][b] * w[2][c], w[0][a] * w[1][b] * d[2][c]);
      }
    }
  }
  gradient *= T(0.5);
  return value;
}

/// The spline sum_j fetch(j) M(p - j) at a finite point p, in lattice coordinates, and its gradient
/// there. fetch maps an even or odd lattice point (glm::ivec3) to its coefficient, a T.
template <class T, class Fetch>
T EvaluateBoxSpline(
  BCCKernel kernel, const Fetch& fetch, const glm::vec<3, T>& p, glm::vec<3, T>& gradient)
{
  if (kernel == BCCKernel::BCC12)
  {
    glm::vec<3, T> odd;
    const T value =
      EvaluateCubicCoset(fetch, p, 0, gradient) + EvaluateCubicCoset(fetch, p, 1, odd);
    gradient = T(0.5) * (gradient + odd);
    return T(0.5) * value;
  }
  const BCCFrame<T> frame = FindBCCFrame(p);
  const glm::vec<3, T>& x = frame.Point;
  const glm::ivec3* s = frame.Steps;
  T c[32];
  T value;
  glm::vec<3, T> g;
  if (kernel == BCCKernel::BCC4)
  {
    BCC4Fetch(frame.Even, frame.Odd, s[0], s[1], s[2], fetch, c);
    value = BCC4Polynomial(x.x, x.y, x.z, c, g.x, g.y, g.z);
  }
  else if (kernel == BCCKernel::BCC7)
  {
    BCC7Fetch(frame.Even, frame.Odd, s[0], s[1], s[2], fetch, c);
    value = BCC7Polynomial(x.x, x.y, x.z, c, g.x, g.y, g.z);
  }
  else
  {
    BCC8Fetch(frame.Even, frame.Odd, s[0], s[1], s[2], fetch, c);
    value = BCC8Polynomial(x.x, x.y, x.z, c, g.x, g.y, g.z);
  }
  gradient = frame.TurnBack(g);
  return value;
}

/// The kernel itself, centred at 0, at a finite point in lattice coordinates, scaled so that its
/// shifts to all lattice points sum to 1 (the box-spline of eq. 9 to 11 times det G = 4).
inline double EvaluateKernel(BCCKernel kernel, const glm::dvec3& p)
{
  const auto delta = [](const glm::ivec3& j) { return j == glm::ivec3(0) ? 1.0 : 0.0; };
  if (glm::any(glm::greaterThanEqual(glm::abs(p), glm::dvec3(4.0))))
  {
    return 0.0; // The widest support, that of bcc8 and bcc12, ends at 4.
  }
  glm::dvec3 gradient;
  return EvaluateBoxSpline(kernel, delta, p, gradient);
}

} // namespace bravais

#endif
