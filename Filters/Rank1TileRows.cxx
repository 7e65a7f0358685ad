// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1TileRows.h"

#include <cmath>
#include <numeric>

namespace bravais
{

namespace
{

/// The Voronoi cell, in pixels.
std::array<glm::dvec2, 6> MakeCorners(const Rank1Lattice& lattice, const glm::dvec2& pixelsPerTile)
{
  std::array<glm::dvec2, 6> corners = lattice.GetVoronoiCell();
  for (glm::dvec2& corner : corners)
  {
    corner *= pixelsPerTile / static_cast<double>(lattice.GetNumberOfPoints());
  }
  return corners;
}

} // namespace

//------------------------------------------------------------------------------
Rank1TileRows::Rank1TileRows(const Rank1LevelPlan& plan, const PictureRows& picture)
  : Lattice(plan.Lattice)
  , Tiles(plan.Parameters.Tiles[0], plan.Parameters.Tiles[1])
  , PixelsPerTile(glm::dvec2(picture.GetWidth(), picture.GetHeight()) / glm::dvec2(this->Tiles))
  , Cell(MakeCorners(plan.Lattice, this->PixelsPerTile))
{
  double reach = 0.0;
  for (const glm::dvec2& corner : MakeCorners(plan.Lattice, this->PixelsPerTile))
  {
    reach = std::max(reach, std::abs(corner.y));
  }
  this->Reach = static_cast<int>(std::ceil(reach)) + 1;
  const std::int64_t n = plan.Lattice.GetNumberOfPoints();
  this->Order.resize(n);
  std::iota(this->Order.begin(), this->Order.end(), std::int64_t{ 0 });
  const auto height = [&](std::int64_t i) { return this->Lattice.GetPoint(i).y; };
  std::stable_sort(this->Order.begin(), this->Order.end(),
    [&](std::int64_t a, std::int64_t b) { return height(a) < height(b); });
  for (const std::int64_t i : this->Order)
  {
    this->Heights.push_back(height(i));
  }
}

//------------------------------------------------------------------------------
void Rank1TileRows::GetTileRows(int first, int last, int tileRows[2]) const
{
  const double height = this->PixelsPerTile.y;
  tileRows[0] = static_cast<int>(first / height);
  tileRows[1] = std::min(this->Tiles.y, static_cast<int>(std::ceil(last / height)));
}

} // namespace bravais
