// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Testing_h
#define Rank1Testing_h

/// \file
/// What the tests of rank-1 lattices share: a set of lattices, and distances by looking everywhere.

#include "Rank1Lattice.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bravais
{

/// Lattices of all kinds: tiny ones, Korobov and not, prime and composite, of several areas.
inline std::vector<Rank1Lattice> MakeRank1Lattices()
{
  std::vector<Rank1Lattice> lattices;
  const std::int64_t generators[][3] = { { 1, 0, 0 }, { 2, 1, 1 }, { 2, 0, 1 }, { 3, 1, 2 },
    { 8, 1, 3 }, { 30, 1, 7 }, { 56, 4, 7 }, { 56, 3, 11 }, { 56, 1, 9 }, { 56, 1, 21 },
    { 56, 7, 4 }, { 97, 5, 31 }, { 128, 1, 1 }, { 210, 14, 15 }, { 256, 1, 30 }, { 500, 1, 499 },
    { 1009, 1, 390 }, { 2048, 31, 39 } };
  const glm::dvec2 sizes[] = { { 1.0, 1.0 }, { 1.5, 1.0 }, { 2.0, 7.0 }, { 300.0, 1.0 } };
  for (const auto& g : generators)
  {
    for (const glm::dvec2& size : sizes)
    {
      lattices.push_back(*Rank1Lattice::Create(g[0], g[1], g[2], size));
    }
  }
  return lattices;
}

/// Distance of two points of the unit torus, on an area of that size, by trying copies all around.
inline double MeasureOnTorus(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& size)
{
  const glm::dvec2 apart = a - b;
  const glm::dvec2 near(apart.x - std::floor(apart.x + 0.5), apart.y - std::floor(apart.y + 0.5));
  return glm::length(near * size);
}

} // namespace bravais

#endif
