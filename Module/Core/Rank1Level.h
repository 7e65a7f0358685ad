// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Level_h
#define Rank1Level_h

/// \file
/// Which level of a rank-1 texture a pixel's footprint asks for.
///
/// A footprint is (du/dx, dv/dx, du/dy, dv/dy), the texture coordinates' derivatives along the two
/// sides of a pixel. The picture is u, v in [0, 1)^2. `density`, from GetRank1Density, is how many
/// spacings of the base's texels it is wide and high; a spacing is the side of the square of a
/// texel's area.
///
/// Levels are of two kinds:
/// - Mip levels. Level l has n / 4^l texels in each tile. It is one number, D = log2 L, L being the
///   longer of the footprint's two axes in texel spacings (the "mipmap equation" of the sampling
///   text).
/// - Members of an r-set. Member (i, j) has S / 2^i x T / 2^j tiles of n texels (Dammertz et al.,
///   Textures on Rank-1 Lattices, section 5.2). They are two numbers, the binary logarithms of the
///   width and height, in texel spacings, of the box round the ellipse that has the footprint's
///   axes as conjugate radii: the lengths of the axes where these are parallel to u and v, and of
///   equal axes at right angles the same number whatever way they are turned.
///
/// A shader has them as functions of the same names and argument order, in Rendering/GLSL.

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace bravais
{

/// The lower of the two levels that are blended, the upper one, and the latter's weight.
struct Rank1LevelBlend
{
  int Lower;
  int Upper;
  double Weight;
};

/// Texel spacings along u and v of a picture of that width and height, with that many texels.
inline glm::dvec2 GetRank1Density(const glm::dvec2& size, double texels)
{
  return glm::sqrt(texels * glm::dvec2(size.x / size.y, size.y / size.x));
}

/// D of the mip levels, not clamped: below 0 where the texture is magnified, -infinity where the
/// footprint is a point.
inline double GetRank1MipLevel(const glm::dvec4& footprint, const glm::dvec2& density)
{
  const glm::dvec2 x = density * glm::dvec2(footprint.x, footprint.y);
  const glm::dvec2 y = density * glm::dvec2(footprint.z, footprint.w);
  return 0.5 * glm::log2(glm::max(glm::dot(x, x), glm::dot(y, y)));
}

/// The same along u and v, for the members of an r-set.
inline glm::dvec2 GetRank1MemberLevel(const glm::dvec4& footprint, const glm::dvec2& density)
{
  const glm::dvec2 u = density.x * glm::dvec2(footprint.x, footprint.z);
  const glm::dvec2 v = density.y * glm::dvec2(footprint.y, footprint.w);
  return 0.5 * glm::log2(glm::dvec2(glm::dot(u, u), glm::dot(v, v)));
}

/// The mip level nearest to D; midway, as in OpenGL, the finer one.
inline int GetNearestRank1Level(double level, int levels)
{
  return static_cast<int>(glm::clamp(glm::ceil(level - 0.5), 0.0, levels - 1.0));
}

/// The levels to blend for a D, of mip levels or of one direction of an r-set.
inline Rank1LevelBlend GetRank1LevelBlend(double level, int levels)
{
  const double clamped = glm::clamp(level, 0.0, levels - 1.0);
  const double lower = glm::min(glm::floor(clamped), glm::max(levels - 2.0, 0.0));
  return { static_cast<int>(lower), static_cast<int>(glm::min(lower + 1.0, levels - 1.0)),
    clamped - lower };
}

/// The member of an r-set of levels.x x levels.y members, by section 5.2: of those whose texels
/// have the footprint's ratio of width to height, i - j being the integer nearest to it, the first
/// whose texel's area is the footprint's or more; the coarsest of them where none is. A footprint
/// may be larger than that by a 256th of a level, so that rounding does not take one of exactly a
/// texel for more.
inline glm::ivec2 GetRank1Member(const glm::dvec2& level, const glm::ivec2& levels)
{
  constexpr double tolerance = 1.0 / 256.0;
  const glm::dvec2 most = glm::dvec2(levels) - 1.0;
  const glm::dvec2 d = glm::clamp(level, glm::dvec2(0.0), most);
  const double ratio = glm::ceil(d.x - d.y - 0.5);
  // Member (i, i - ratio) has texels of 2^(2 i - ratio) times the base's area.
  const double first = glm::max(0.0, ratio);
  const double last = glm::min(most.x, most.y + ratio);
  const double i = glm::ceil(0.5 * (d.x + d.y + ratio - tolerance));
  const double column = glm::clamp(i, first, last);
  return glm::ivec2(glm::dvec2(column, column - ratio));
}

} // namespace bravais

#endif
