// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1LookUp_h
#define Rank1LookUp_h

/// \file
/// Values of a rank-1 picture at its points, by the interpolations of Rank1Interpolation.h.

#include "Rank1BoxSpline.h"

namespace bravais
{

enum class Rank1Interpolation
{
  Nearest,
  Bilinear,
  Barycentric,
  BoxSpline
};

/// Adds `weight` times a sum of texels, each of so many components. Texels of no weight are not
/// read, so one that is not a number spoils only what it is a part of.
template <int Count, class T, class Value>
inline void AddRank1Texels(const Rank1Integer<T> (&texels)[Count], const T (&weights)[Count],
  const Value* values, int components, T weight, T* sum)
{
  for (int i = 0; i < Count; ++i)
  {
    if (weights[i] != T(0))
    {
      const Value* texel = values + std::int64_t{ texels[i] } * components;
      for (int c = 0; c < components; ++c)
      {
        sum[c] += weight * weights[i] * static_cast<T>(texel[c]);
      }
    }
  }
}

/// Adds `weight` times the picture's value at (u, v), in units of the picture.
template <class T, class Value>
inline void AddRank1Value(const Rank1Texture<T>& texture, Rank1Interpolation interpolation,
  const glm::vec<2, T>& uv, const Value* values, int components, T weight, T* sum)
{
  switch (interpolation)
  {
    case Rank1Interpolation::Nearest:
    {
      const Rank1Integer<T> texels[1] = { FindRank1Nearest(texture, uv) };
      const T weights[1] = { T(1) };
      AddRank1Texels(texels, weights, values, components, weight, sum);
      break;
    }
    case Rank1Interpolation::Bilinear:
    {
      Rank1Integer<T> texels[4];
      T weights[4];
      FindRank1Bilinear(texture, uv, texels, weights);
      AddRank1Texels(texels, weights, values, components, weight, sum);
      break;
    }
    case Rank1Interpolation::Barycentric:
    {
      Rank1Integer<T> texels[3];
      T weights[3];
      FindRank1Barycentric(texture, uv, texels, weights);
      AddRank1Texels(texels, weights, values, components, weight, sum);
      break;
    }
    default:
    {
      Rank1Integer<T> texels[12];
      T weights[12];
      FindRank1BoxSpline(texture, uv, texels, weights);
      AddRank1Texels(texels, weights, values, components, weight, sum);
    }
  }
}

} // namespace bravais

#endif
