// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Sampling_h
#define Rank1Sampling_h

#include "Rank1BoxSpline.h"
#include "Rank1Level.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace bravais
{

/// What is between texels.
enum class Rank1LookUp
{
  Nearest,
  Bilinear,
  Barycentric,
  BoxSpline
};

/// A texture of several levels, and how it is looked up: rank1LookUp.glsl on the CPU.
struct Rank1Sampling
{
  std::vector<Rank1Texture<double>> Levels; ///< in the order of Rank1TextureLevels.h
  glm::ivec2 Counts = { 0, 0 };             ///< columns and rows of an r-set; mip levels and 1
  glm::dvec2 Density = { 1.0, 1.0 };        ///< of the base, by GetRank1Density
  bool IsRSet = false;
  bool Trilinear = true; ///< else the nearest level alone
  Rank1LookUp LookUp = Rank1LookUp::Barycentric;
};

/// The member, or the mip level and 0, that a look-up of one level takes.
inline glm::ivec2 GetRank1NearestMember(const Rank1Sampling& sampling, const glm::dvec4& footprint)
{
  const glm::ivec2& counts = sampling.Counts;
  return sampling.IsRSet
    ? GetRank1Member(GetRank1MemberLevel(footprint, sampling.Density), counts)
    : glm::ivec2(GetNearestRank1Level(GetRank1MipLevel(footprint, sampling.Density), counts.x), 0);
}

/// Calls add(level, texel, weight) for the texels of one level that make up the value at uv.
template <class Add>
void VisitRank1Level(
  const Rank1Sampling& sampling, int level, const glm::dvec2& uv, double share, const Add& add)
{
  const Rank1Texture<double>& texture = sampling.Levels[level];
  std::int64_t texels[12];
  double weights[12];
  int count = 1;
  switch (sampling.LookUp)
  {
    case Rank1LookUp::Nearest:
      texels[0] = FindRank1Nearest(texture, uv);
      weights[0] = 1.0;
      break;
    case Rank1LookUp::Bilinear:
      FindRank1Bilinear(texture, uv, texels, weights);
      count = 4;
      break;
    case Rank1LookUp::Barycentric:
      FindRank1Barycentric(texture, uv, texels, weights);
      count = 3;
      break;
    case Rank1LookUp::BoxSpline:
      FindRank1BoxSpline(texture, uv, texels, weights);
      count = 12;
      break;
  }
  for (int i = 0; i < count; ++i)
  {
    if (weights[i] != 0.0) // a texel of no weight may be infinite
    {
      add(level, texels[i], share * weights[i]);
    }
  }
}

/// The same for the filtered value of a finite uv and a footprint that is not NaN.
template <class Add>
void VisitRank1Texels(
  const Rank1Sampling& sampling, const glm::dvec2& uv, const glm::dvec4& footprint, const Add& add)
{
  const glm::ivec2& counts = sampling.Counts;
  if (!sampling.Trilinear)
  {
    const glm::ivec2 member = GetRank1NearestMember(sampling, footprint);
    VisitRank1Level(sampling, member.x + counts.x * member.y, uv, 1.0, add);
    return;
  }
  const glm::dvec2 level = sampling.IsRSet
    ? GetRank1MemberLevel(footprint, sampling.Density)
    : glm::dvec2(GetRank1MipLevel(footprint, sampling.Density), 0.0);
  const Rank1LevelBlend columns = GetRank1LevelBlend(level.x, counts.x);
  const Rank1LevelBlend rows = GetRank1LevelBlend(level.y, counts.y);
  for (int corner = 0; corner < 4; ++corner)
  {
    const bool right = (corner & 1) != 0;
    const bool up = (corner & 2) != 0;
    const double share =
      (right ? columns.Weight : 1.0 - columns.Weight) * (up ? rows.Weight : 1.0 - rows.Weight);
    if (share > 0.0)
    {
      const int member =
        (right ? columns.Upper : columns.Lower) + counts.x * (up ? rows.Upper : rows.Lower);
      VisitRank1Level(sampling, member, uv, share, add);
    }
  }
}

} // namespace bravais

#endif
