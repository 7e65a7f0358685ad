// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Levels.h"

namespace bravais
{

//------------------------------------------------------------------------------
std::optional<std::vector<Rank1LevelPlan>> PlanRank1MipLevels(
  const Rank1Picture& picture, const Rank1ResampleParameters& base, int levels, std::string& why)
{
  int dimensions[3];
  if (!FindRank1Dimensions(picture, base, dimensions, why))
  {
    return std::nullopt;
  }
  std::vector<Rank1LevelPlan> plans;
  Rank1ResampleParameters own = base;
  for (own.NumberOfPoints = dimensions[0]; own.NumberOfPoints > 0; own.NumberOfPoints /= 4)
  {
    const auto lattice = FindRank1Lattice(picture, own, why);
    if (!lattice)
    {
      return std::nullopt;
    }
    plans.push_back({ own, *lattice, "level " + std::to_string(plans.size()) });
    own.Generator[0] = own.Generator[1] = 0;
    if (levels > 0 && static_cast<int>(plans.size()) == levels)
    {
      break;
    }
  }
  return plans;
}

//------------------------------------------------------------------------------
std::optional<std::vector<Rank1LevelPlan>> PlanRank1RSet(
  const Rank1Picture& picture, const Rank1ResampleParameters& base, std::string& why)
{
  const auto lattice = FindRank1Lattice(picture, base, why);
  if (!lattice)
  {
    return std::nullopt;
  }
  std::vector<Rank1LevelPlan> plans;
  Rank1ResampleParameters own = base;
  own.NumberOfPoints = lattice->GetNumberOfPoints();
  own.Generator[0] = lattice->GetGenerator().x;
  own.Generator[1] = lattice->GetGenerator().y;
  if (own.NumberOfPoints == 1)
  {
    own.Generator[0] = own.Generator[1] = 1; // 0, 0 would ask for a search
  }
  for (own.Tiles[1] = base.Tiles[1]; own.Tiles[1] > 0; own.Tiles[1] /= 2)
  {
    for (own.Tiles[0] = base.Tiles[0]; own.Tiles[0] > 0; own.Tiles[0] /= 2)
    {
      const auto member = FindRank1Lattice(picture, own, why);
      if (!member)
      {
        return std::nullopt;
      }
      plans.push_back({ own, *member,
        std::to_string(own.Tiles[0]) + " x " + std::to_string(own.Tiles[1]) + " tiles" });
    }
  }
  return plans;
}

} // namespace bravais
