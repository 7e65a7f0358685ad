// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1BoxSpline_h
#define Rank1BoxSpline_h

/// \file
/// Look-ups in a rank-1 picture by a C2 box-spline of its texels, over Rank1Interpolation.h's
/// triangles.

#include "Rank1Interpolation.h"

namespace bravais
{

/// Weights of the quartic box-spline of the directions b1, b2 and b2 - b1, each taken twice: C2,
/// and 1/2 at its own texel and 1/12 at the six neighbours. From the barycentric coordinates of a
/// triangle ABC follow those of A, B, C; of B + C - A, C + A - B, A + B - C; and of 2A - B, 2A - C,
/// 2B - C, 2B - A, 2C - A, 2C - B.
template <class T>
inline void EvaluateRank1BoxSpline(const glm::vec<3, T>& barycentric, T weights[12])
{
  using V = glm::vec<3, T>;
  const V p = barycentric;
  const V q(p.y, p.z, p.x); // the next coordinate of each
  const V r(p.z, p.x, p.y); // and the one after that
  const V p2 = p * p;
  const V p4 = p2 * p2;
  const V q2 = q * q;
  const V r2 = r * r;
  const V qr = q * r;
  const V q4r4 = q2 * q2 + r2 * r2;
  const V vertex = T(6) * p4 + T(24) * p2 * p * (q + r) + p2 * (T(24) * (q2 + r2) + T(60) * qr) +
    p * (T(8) * (q2 * q + r2 * r) + T(36) * qr * (q + r)) + q4r4 + T(6) * qr * (q2 + r2) +
    T(12) * qr * qr;
  const V across = q4r4 + T(6) * qr * (q2 + r2) + T(12) * qr * qr +
    p * (T(2) * (q2 * q + r2 * r) + T(6) * qr * (q + r));
  const V awayFromNext = p4 + T(2) * p2 * p * r; // 2A - B is on the side of C
  const V awayFromLast = p4 + T(2) * p2 * p * q;
  for (int i = 0; i < 3; ++i)
  {
    weights[i] = vertex[i] * T(1.0 / 12.0);
    weights[3 + i] = across[i] * T(1.0 / 12.0);
    weights[6 + 2 * i] = awayFromNext[i] * T(1.0 / 12.0);
    weights[7 + 2 * i] = awayFromLast[i] * T(1.0 / 12.0);
  }
}

/// Indices of the box-spline's stencil, in the order of its weights, round a triangle's corner.
template <class Int>
inline void FindRank1Stencil(Int corner, const glm::vec<2, Int>& steps, Int n, Int texels[12])
{
  const glm::vec<2, Int> back(steps.x > 0 ? n - steps.x : 0, steps.y > 0 ? n - steps.y : 0);
  texels[0] = corner;
  texels[1] = Rank1Step(corner, steps.x, n);
  texels[2] = Rank1Step(corner, steps.y, n);
  texels[3] = Rank1Step(texels[1], steps.y, n);
  texels[4] = Rank1Step(texels[2], back.x, n);
  texels[5] = Rank1Step(texels[1], back.y, n);
  texels[6] = Rank1Step(corner, back.x, n);
  texels[7] = Rank1Step(corner, back.y, n);
  texels[8] = Rank1Step(texels[5], steps.x, n);
  texels[9] = Rank1Step(texels[1], steps.x, n);
  texels[10] = Rank1Step(texels[2], steps.y, n);
  texels[11] = Rank1Step(texels[4], steps.y, n);
}

/// The box-spline of the texels as its coefficients.
template <class T>
inline void FindRank1BoxSpline(const Rank1Texture<T>& texture, const glm::vec<2, T>& uv,
  Rank1Integer<T> texels[12], T weights[12])
{
  using Point = glm::vec<2, Rank1Integer<T>>;
  const Point stencil[12] = { Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1), Point(-1, 1),
    Point(1, -1), Point(-1, 0), Point(0, -1), Point(2, -1), Point(2, 0), Point(0, 2),
    Point(-1, 2) };
  const Rank1Site<T> site = FindRank1Site(texture, uv);
  const Rank1Triangle<T> triangle = FindRank1Triangle(site);
  EvaluateRank1BoxSpline(triangle.Barycentric, weights);
  if (IsRank1Single(texture))
  {
    FindRank1Stencil(Rank1Index(texture, triangle.Corner), FindRank1Steps(texture, triangle.Sign),
      texture.NumberOfPoints, texels);
    return;
  }
  for (int i = 0; i < 12; ++i)
  {
    texels[i] = Rank1Texel(texture, site.Tile, triangle.Corner + triangle.Sign * stencil[i]);
  }
}

} // namespace bravais

#endif
