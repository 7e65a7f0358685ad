// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Search_h
#define Rank1Search_h

/// \file
/// Finding good rank-1 lattices, and good generators of one lattice.

#include "Rank1Lattice.h"

namespace bravais
{

/// Which of the generators of one lattice: they number its texels in different orders.
enum class Rank1Layout
{
  Korobov, ///< (1, a) where there is one, else the one of least g1, then g2: index follows u
  Locality ///< the shortest one: texels of consecutive indices are neighbours
};

/**
 * The lattice of n points whose minimum distance is the largest, of all rank-1 lattices of n points
 * on an area of that size. Exact, for every n, in a time that grows like the square root of n.
 *
 * Rank-1 lattices are the sublattices of the integers of determinant n whose quotient is cyclic.
 * One with a shortest vector v has a reduced basis (v, w), and |v|^2 <= 2 / sqrt(3) n by Hermite.
 * So vectors v are tried by descending length, a thin ring at a time; gcd(v) has to divide n,
 * det(v, w) = n puts w on a line, and |<v, w>| <= |v|^2 / 2 leaves about gcd(v) of its points. The
 * first ring that has a lattice has the best ones, and all of them.
 *
 * Of equally good lattices the one with the least generator (g1, g2) is taken, so one in Korobov
 * form, g1 = 1, where there is any; lengths are equal that differ by 1e-12. Then `layout` chooses
 * among this lattice's generators. None where there is no lattice of n points, see
 * Rank1Lattice::Create.
 */
std::optional<Rank1Lattice> MaximizeMinimumDistance(
  std::int64_t n, const glm::dvec2& size = { 1.0, 1.0 }, Rank1Layout layout = Rank1Layout::Korobov);

/// The same points by another generator.
Rank1Lattice ChooseGenerator(const Rank1Lattice& lattice, Rank1Layout layout);

/// How far apart neighbours are in memory: the share of steps to one of the six neighbours that
/// leave a line of so many texels, the mean of min(1, d / line) over the distances d in memory,
/// which count modulo n. 0 is best; a square picture of long rows has (1 / line + 1) / 2 for its
/// four.
double MeasureLayout(const Rank1Lattice& lattice, int line);

} // namespace bravais

#endif
