// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Levels_h
#define Rank1Levels_h

/// \file
/// The levels that a rank-1 texture is to have, in the order of Rank1TextureLevels.h.

#include "Rank1Resample.h"

#include <optional>
#include <string>
#include <vector>

namespace bravais
{

/// A level before it is computed.
struct Rank1LevelPlan
{
  Rank1ResampleParameters Parameters; ///< those of the base, with its own tiles and texels
  Rank1Lattice Lattice;               ///< of one tile
  std::string Name;
};

/// Mip levels of a base with those parameters: at most `levels` of them where that is not 0.
std::optional<std::vector<Rank1LevelPlan>> PlanRank1MipLevels(
  const Rank1Picture& picture, const Rank1ResampleParameters& base, int levels, std::string& why);

/// Members of the r-set of a base with those parameters.
std::optional<std::vector<Rank1LevelPlan>> PlanRank1RSet(
  const Rank1Picture& picture, const Rank1ResampleParameters& base, std::string& why);

} // namespace bravais

#endif
