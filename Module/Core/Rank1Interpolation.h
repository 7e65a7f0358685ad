// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Interpolation_h
#define Rank1Interpolation_h

/// \file
/// Look-ups in a rank-1 picture: which texels a point of the picture takes, and with what weights.
/// Rank1Index.h tells of the picture, the types and the shaders' twins.

#include "Rank1Index.h"

namespace bravais
{

/// The texel nearest to a point. In a reduced basis it is at one of its cell's corners.
template <class T>
inline Rank1Integer<T> FindRank1Nearest(const Rank1Texture<T>& texture, const glm::vec<2, T>& uv)
{
  using Int = Rank1Integer<T>;
  const Rank1Site<T> site = FindRank1Site(texture, uv);
  const T x = site.Fraction.x;
  const T y = site.Fraction.y;
  // Squared distances to the corners, less that to the cell's own, which may be large.
  const glm::vec<3, T>& m = texture.Metric;
  const T d10 = m.x * (T(1) - T(2) * x) - m.y * y;
  const T d01 = m.z * (T(1) - T(2) * y) - m.y * x;
  const bool right0 = d10 < T(0);
  const bool right1 = d10 + m.y < T(0);
  const bool up = d01 + (right1 ? d10 + m.y : T(0)) < (right0 ? d10 : T(0));
  const Int s = (up ? right1 : right0) ? Int(1) : Int(0);
  const Int t = up ? Int(1) : Int(0);
  return Rank1Texel(texture, site.Tile, site.Cell + glm::vec<2, Int>(s, t));
}

/// Bilinear interpolation between the corners of the fundamental parallelepiped.
template <class T>
inline void FindRank1Bilinear(
  const Rank1Texture<T>& texture, const glm::vec<2, T>& uv, Rank1Integer<T> texels[4], T weights[4])
{
  using Point = glm::vec<2, Rank1Integer<T>>;
  const Rank1Site<T> site = FindRank1Site(texture, uv);
  const glm::vec<2, T> f = site.Fraction;
  texels[0] = Rank1Texel(texture, site.Tile, site.Cell);
  if (IsRank1Single(texture))
  {
    const Rank1Integer<T> n = texture.NumberOfPoints;
    texels[1] = Rank1Step(texels[0], texture.Indices.x, n);
    texels[2] = Rank1Step(texels[0], texture.Indices.y, n);
    texels[3] = Rank1Step(texels[1], texture.Indices.y, n);
  }
  else
  {
    texels[1] = Rank1Texel(texture, site.Tile, site.Cell + Point(1, 0));
    texels[2] = Rank1Texel(texture, site.Tile, site.Cell + Point(0, 1));
    texels[3] = Rank1Texel(texture, site.Tile, site.Cell + Point(1, 1));
  }
  weights[0] = (T(1) - f.x) * (T(1) - f.y);
  weights[1] = f.x * (T(1) - f.y);
  weights[2] = (T(1) - f.x) * f.y;
  weights[3] = f.x * f.y;
}

/// The Delaunay triangle of a site: vertices Corner, Corner + (Sign, 0), Corner + (0, Sign), and
/// the point's barycentric coordinates.
template <class T>
struct Rank1Triangle
{
  glm::vec<2, Rank1Integer<T>> Corner;
  Rank1Integer<T> Sign;
  glm::vec<3, T> Barycentric;
};

/// A cell's shorter diagonal, from b1 to b2, parts it into two triangles.
template <class T>
inline Rank1Triangle<T> FindRank1Triangle(const Rank1Site<T>& site)
{
  using Int = Rank1Integer<T>;
  const glm::vec<2, T> f = site.Fraction;
  const bool upper = f.x + f.y > T(1);
  Rank1Triangle<T> triangle;
  triangle.Corner = site.Cell + (upper ? Int(1) : Int(0));
  triangle.Sign = upper ? Int(-1) : Int(1);
  const glm::vec<2, T> bc = upper ? T(1) - f : f;
  triangle.Barycentric = glm::vec<3, T>(T(1) - bc.x - bc.y, bc.x, bc.y);
  return triangle;
}

/// Indices of the steps from a triangle's corner along b1 and b2, or against them.
template <class T>
inline glm::vec<2, Rank1Integer<T>> FindRank1Steps(
  const Rank1Texture<T>& texture, Rank1Integer<T> sign)
{
  const Rank1Integer<T> n = texture.NumberOfPoints;
  const glm::vec<2, Rank1Integer<T>>& kl = texture.Indices;
  return sign > 0 ? kl
                  : glm::vec<2, Rank1Integer<T>>(kl.x > 0 ? n - kl.x : 0, kl.y > 0 ? n - kl.y : 0);
}

/// Linear interpolation on the Delaunay triangle.
template <class T>
inline void FindRank1Barycentric(
  const Rank1Texture<T>& texture, const glm::vec<2, T>& uv, Rank1Integer<T> texels[3], T weights[3])
{
  using Point = glm::vec<2, Rank1Integer<T>>;
  const Rank1Site<T> site = FindRank1Site(texture, uv);
  const Rank1Triangle<T> triangle = FindRank1Triangle(site);
  texels[0] = Rank1Texel(texture, site.Tile, triangle.Corner);
  if (IsRank1Single(texture))
  {
    const Rank1Integer<T> n = texture.NumberOfPoints;
    const Point steps = FindRank1Steps(texture, triangle.Sign);
    texels[1] = Rank1Step(texels[0], steps.x, n);
    texels[2] = Rank1Step(texels[0], steps.y, n);
  }
  else
  {
    texels[1] = Rank1Texel(texture, site.Tile, triangle.Corner + Point(triangle.Sign, 0));
    texels[2] = Rank1Texel(texture, site.Tile, triangle.Corner + Point(0, triangle.Sign));
  }
  weights[0] = triangle.Barycentric.x;
  weights[1] = triangle.Barycentric.y;
  weights[2] = triangle.Barycentric.z;
}

} // namespace bravais

#endif
