// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Interpolation_h
#define Rank1Interpolation_h

/// \file
/// Look-ups in a rank-1 picture: which texels a point of the picture takes, and with what weights.
///
/// A picture is S x T tiles of one lattice (Dammertz, Dammertz, Keller and Lensch, Textures on
/// Rank-1 Lattices, sections 4, 5.1 and 5.2). Texel i of tile (x, y) is number i + n (x + S y). A
/// neighbour beyond a tile's edge is in the next tile, and the picture as a whole is periodic.
///
/// These are the twins of Rendering/GLSL. T is the type of real numbers, and integers have as many
/// bits: float is what a shader has, and enough for n up to 2^24 of ordinary aspect. Products of
/// integers may wrap around; what is left of them is small, and so is right. There is no branch on
/// the point.

#include "Rank1Lattice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <type_traits>

namespace bravais
{

/// The integer of as many bits as a real type.
template <class T>
using Rank1Integer = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

/// A lattice and its tiles as plain numbers: uniforms of a shader.
template <class T>
struct Rank1Texture
{
  using Int = Rank1Integer<T>;
  glm::vec<4, T> ToBasis;     ///< s = ToBasis.x u + ToBasis.y v, t = ToBasis.z u + ToBasis.w v
  glm::vec<3, T> Metric;      ///< b1.b1, 2 b1.b2, b2.b2, on the tile's shape, over b1.b1
  glm::vec<2, T> IndexShares; ///< k / n, l / n
  T Reciprocal;               ///< 1 / n
  Int NumberOfPoints;         ///< n
  glm::vec<2, Int> Indices;   ///< k, l
  glm::vec<4, Int> Basis;     ///< b1.x, b1.y, b2.x, b2.y on the n x n grid
  glm::vec<2, Int> Tiles;     ///< S, T
};

/// The numbers of a lattice whose `size` is that of one tile.
template <class T>
Rank1Texture<T> MakeRank1Texture(const Rank1Lattice& lattice, int tilesX = 1, int tilesY = 1)
{
  using Int = Rank1Integer<T>;
  const auto n = static_cast<double>(lattice.GetNumberOfPoints());
  const double scale = glm::max(lattice.GetSize().x, lattice.GetSize().y);
  const glm::dvec2 a = lattice.ToArea(glm::dvec2(lattice.GetBasis(0))) / scale;
  const glm::dvec2 b = lattice.ToArea(glm::dvec2(lattice.GetBasis(1))) / scale;
  const glm::dvec2 u = lattice.ToBasis({ 1.0, 0.0 });
  const glm::dvec2 v = lattice.ToBasis({ 0.0, 1.0 });
  const glm::dvec2 indices(
    static_cast<double>(lattice.GetBasisIndex(0)), static_cast<double>(lattice.GetBasisIndex(1)));
  Rank1Texture<T> texture;
  texture.ToBasis = glm::vec<4, T>(u.x, v.x, u.y, v.y);
  texture.Metric =
    glm::vec<3, T>(1.0, 2.0 * glm::dot(a, b) / glm::dot(a, a), glm::dot(b, b) / glm::dot(a, a));
  texture.IndexShares = glm::vec<2, T>(indices / n);
  texture.Reciprocal = static_cast<T>(1.0 / n);
  texture.NumberOfPoints = static_cast<Int>(lattice.GetNumberOfPoints());
  texture.Indices = glm::vec<2, Int>(indices);
  texture.Basis = glm::vec<4, Int>(
    lattice.GetBasis(0).x, lattice.GetBasis(0).y, lattice.GetBasis(1).x, lattice.GetBasis(1).y);
  texture.Tiles = glm::vec<2, Int>(tilesX, tilesY);
  return texture;
}

/// A point of the picture: its tile, the corner s b1 + t b2 of its cell, counted from the tile's
/// corner, and where it is in the cell, 0 to 1.
template <class T>
struct Rank1Site
{
  glm::vec<2, Rank1Integer<T>> Tile;
  glm::vec<2, Rank1Integer<T>> Cell;
  glm::vec<2, T> Fraction;
};

/// The largest integer that is not above x, which has to fit: less work than std::floor where that
/// is a call.
template <class T>
inline Rank1Integer<T> Rank1Floor(T x)
{
  const auto whole = static_cast<Rank1Integer<T>>(x);
  return whole - (static_cast<T>(whole) > x ? 1 : 0);
}

/// What is after the point of a finite number.
template <class T>
inline T Rank1Fraction(T x)
{
  constexpr T large(1 << 30);
  return x > -large && x < large ? x - static_cast<T>(Rank1Floor(x)) : x - glm::floor(x);
}

/// The site of a finite point, in units of the picture.
template <class T>
inline Rank1Site<T> FindRank1Site(const Rank1Texture<T>& texture, const glm::vec<2, T>& uv)
{
  using Int = Rank1Integer<T>;
  const glm::vec<2, T> p =
    glm::vec<2, T>(Rank1Fraction(uv.x), Rank1Fraction(uv.y)) * glm::vec<2, T>(texture.Tiles);
  Rank1Site<T> site;
  site.Tile = glm::min(glm::vec<2, Int>(p), texture.Tiles - Int(1));
  const glm::vec<2, T> local = p - glm::vec<2, T>(site.Tile);
  const glm::vec<2, T> st(texture.ToBasis.x * local.x + texture.ToBasis.y * local.y,
    texture.ToBasis.z * local.x + texture.ToBasis.w * local.y);
  site.Cell = glm::vec<2, Int>(Rank1Floor(st.x), Rank1Floor(st.y));
  site.Fraction = st - glm::vec<2, T>(site.Cell);
  return site;
}

/// a x + b y - c z modulo 2^bits: right where the result fits.
template <class Int>
inline Int Rank1Sum(Int a, Int x, Int b, Int y, Int c, Int z)
{
  using Unsigned = std::make_unsigned_t<Int>;
  return static_cast<Int>(static_cast<Unsigned>(a) * static_cast<Unsigned>(x) +
    static_cast<Unsigned>(b) * static_cast<Unsigned>(y) -
    static_cast<Unsigned>(c) * static_cast<Unsigned>(z));
}

/// x modulo n, for an x of a few n.
template <class T>
inline Rank1Integer<T> Rank1Modulo(Rank1Integer<T> x, Rank1Integer<T> n, T reciprocal)
{
  using Int = Rank1Integer<T>;
  const Int rest = x - Rank1Floor(static_cast<T>(x) * reciprocal) * n;
  const Int positive = rest < Int(0) ? rest + n : rest;
  return positive >= n ? positive - n : positive;
}

/// Index of the point s b1 + t b2 (Theorem 2). The quotient is found in real numbers and may be one
/// too large or too small.
template <class T>
inline Rank1Integer<T> Rank1Index(
  const Rank1Texture<T>& texture, const glm::vec<2, Rank1Integer<T>>& st)
{
  using Int = Rank1Integer<T>;
  const Int n = texture.NumberOfPoints;
  const Int turns = Rank1Floor(glm::dot(glm::vec<2, T>(st), texture.IndexShares));
  const Int rest = Rank1Sum(st.x, texture.Indices.x, st.y, texture.Indices.y, turns, n);
  const Int positive = rest < Int(0) ? rest + n : rest;
  return positive >= n ? positive - n : positive;
}

/// Index of the point a step of index `step` away, both in 0 .. n - 1.
template <class Int>
inline Int Rank1Step(Int index, Int step, Int n)
{
  const Int sum = index - (n - step);
  return sum < Int(0) ? sum + n : sum;
}

/// Whether a texel's number is its index alone.
template <class T>
inline bool IsRank1Single(const Rank1Texture<T>& texture)
{
  return texture.Tiles.x == 1 && texture.Tiles.y == 1;
}

/// Number of the texel at s b1 + t b2 from the corner of a tile.
template <class T>
inline Rank1Integer<T> Rank1Texel(const Rank1Texture<T>& texture,
  const glm::vec<2, Rank1Integer<T>>& tile, const glm::vec<2, Rank1Integer<T>>& st)
{
  using Int = Rank1Integer<T>;
  const Int index = Rank1Index(texture, st);
  if (IsRank1Single(texture))
  {
    return index;
  }
  const Int n = texture.NumberOfPoints;
  const Int x = Rank1Sum(st.x, texture.Basis.x, st.y, texture.Basis.z, Int(0), Int(0));
  const Int y = Rank1Sum(st.x, texture.Basis.y, st.y, texture.Basis.w, Int(0), Int(0));
  // Where the point is in its own tile tells which one that is.
  const Int column = tile.x + (x - Rank1Modulo(x, n, texture.Reciprocal)) / n;
  const Int row = tile.y + (y - Rank1Modulo(y, n, texture.Reciprocal)) / n;
  const Int wrappedColumn = Rank1Modulo(column, texture.Tiles.x, T(1) / T(texture.Tiles.x));
  const Int wrappedRow = Rank1Modulo(row, texture.Tiles.y, T(1) / T(texture.Tiles.y));
  return index + n * (wrappedColumn + texture.Tiles.x * wrappedRow);
}

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
