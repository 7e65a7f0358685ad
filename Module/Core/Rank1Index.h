// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Index_h
#define Rank1Index_h

/// \file
/// Texels of a rank-1 picture by where they are: the cell of a point, and the number of a texel.
///
/// A picture is S x T tiles of one lattice (Dammertz, Dammertz, Keller and Lensch, Textures on
/// Rank-1 Lattices, sections 4, 5.1 and 5.2). Texel i of tile (x, y) is number i + n (x + S y). A
/// neighbour beyond a tile's edge is in the next tile, and the picture as a whole is periodic.
///
/// This, Rank1Interpolation.h and Rank1BoxSpline.h are the twins of Rendering/GLSL. T is the type
/// of real numbers, and integers have as many bits: float is what a shader has, and enough for n up
/// to 2^24 of ordinary aspect. Products of integers may wrap around; what is left of them is small,
/// and so is right. There is no branch on the point.

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

} // namespace bravais

#endif
