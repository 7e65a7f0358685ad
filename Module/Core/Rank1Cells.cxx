// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Cells.h"

#include <glm/common.hpp>

#include <cmath>
#include <utility>

namespace bravais
{

namespace
{

using Part = Rank1Cells::Part;
using Corner = Rank1Cells::Corner;

constexpr double None = 1e-13; ///< of the picture: a width that is rounding

/// The part of a convex polygon where sign * (coordinate - bound) >= 0.
void Clip(const Part& polygon, int axis, double bound, double sign, Part& result)
{
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner& p = polygon[i];
    const Corner& q = polygon[(i + 1) % polygon.size()];
    const double dp = sign * (p.Position[axis] - bound);
    const double dq = sign * (q.Position[axis] - bound);
    if (dp >= 0.0)
    {
      result.push_back(p);
    }
    if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0))
    {
      const double share = dp / (dp - dq);
      Corner cut{ p.Position + (q.Position - p.Position) * share,
        p.Barycentric + (q.Barycentric - p.Barycentric) * share };
      cut.Position[axis] = bound;
      result.push_back(cut);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Rank1Cells::Rank1Cells(const Rank1Lattice& lattice, int tilesX, int tilesY)
  : Lattice(lattice)
  , Texture(MakeRank1Texture<double>(lattice, tilesX, tilesY))
  , Tiles(tilesX, tilesY)
  , Cell(lattice.GetVoronoiCell())
{
  for (glm::dvec2& corner : this->Cell)
  {
    corner /= this->Tiles * static_cast<double>(lattice.GetNumberOfPoints());
  }
}

//------------------------------------------------------------------------------
std::int64_t Rank1Cells::GetNumberOfTexels() const
{
  return this->Texture.NumberOfPoints * this->Texture.Tiles.x * this->Texture.Tiles.y;
}

//------------------------------------------------------------------------------
glm::dvec2 Rank1Cells::GetPoint(std::int64_t texel) const
{
  const std::int64_t n = this->Texture.NumberOfPoints;
  const std::int64_t tile = texel / n;
  const glm::dvec2 corner(static_cast<double>(tile % this->Texture.Tiles.x),
    static_cast<double>(tile / this->Texture.Tiles.x));
  return (corner + this->Lattice.GetPoint(texel)) / this->Tiles;
}

//------------------------------------------------------------------------------
void Rank1Cells::FindParts(const Part& polygon, std::vector<Part>& parts) const
{
  glm::dvec2 low = polygon[0].Position;
  glm::dvec2 high = low;
  for (const Corner& corner : polygon)
  {
    low = glm::min(low, corner.Position);
    high = glm::max(high, corner.Position);
  }
  // Pictures beside the first that it reaches into, by more than rounding.
  const glm::ivec2 first(glm::floor(low + None));
  const glm::ivec2 last(glm::ceil(high - None) - 1.0);
  Part moved;
  Part other;
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      moved = polygon;
      for (Corner& corner : moved)
      {
        corner.Position -= glm::dvec2(x, y);
      }
      for (int axis = 0; axis < 2 && !moved.empty(); ++axis)
      {
        Clip(moved, axis, 0.0, 1.0, other);
        Clip(other, axis, 1.0, -1.0, moved);
      }
      if (moved.size() >= 3)
      {
        parts.push_back(moved);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Rank1Cells::FindCellParts(std::int64_t texel, std::vector<Part>& parts) const
{
  const glm::dvec2 center = this->GetPoint(texel);
  Part polygon;
  for (int i = 0; i < 6; ++i)
  {
    // Two corners of a rectangle's six are the same; they may differ by rounding.
    const glm::dvec2 apart = glm::abs(this->Cell[i] - this->Cell[(i + 1) % 6]);
    if (apart.x > None || apart.y > None)
    {
      polygon.push_back({ center + this->Cell[i], glm::dvec3(0.0) });
    }
  }
  parts.clear();
  this->FindParts(polygon, parts);
}

//------------------------------------------------------------------------------
Rank1Cells::Triangle Rank1Cells::GetTriangle(std::int64_t texel, int which) const
{
  using Point = glm::vec<2, std::int64_t>;
  const std::int64_t n = this->Texture.NumberOfPoints;
  const std::int64_t columns = this->Texture.Tiles.x;
  const Point tile(texel / n % columns, texel / n / columns);
  const Point own = this->Lattice.GetGridPoint(texel);
  // Coordinates in the basis of the texel are integers, but for rounding.
  const glm::dvec2 st = this->Lattice.ToBasis(this->Lattice.GetPoint(texel));
  const Point corner(glm::floor(st + 0.5));
  std::array<Point, 3> steps = which == 0
    ? std::array<Point, 3>{ Point(0, 0), Point(1, 0), Point(0, 1) }
    : std::array<Point, 3>{ Point(1, 1), Point(0, 1), Point(1, 0) };
  if (this->Lattice.GetDeterminant() < 0)
  {
    std::swap(steps[1], steps[2]);
  }
  Triangle triangle;
  triangle.IsInside = true;
  for (int i = 0; i < 3; ++i)
  {
    const Point step =
      steps[i].x * this->Lattice.GetBasis(0) + steps[i].y * this->Lattice.GetBasis(1);
    const Point place = tile * n + own + step;
    triangle.Texels[i] = Rank1Texel(this->Texture, tile, corner + steps[i]);
    triangle.Positions[i] = glm::dvec2(place) / (this->Tiles * static_cast<double>(n));
    triangle.IsInside = triangle.IsInside && place.x >= 0 && place.y >= 0 &&
      place.x < n * this->Texture.Tiles.x && place.y < n * this->Texture.Tiles.y;
  }
  return triangle;
}

//------------------------------------------------------------------------------
void Rank1Cells::FindTriangleParts(const Triangle& triangle, std::vector<Part>& parts) const
{
  const Part polygon = { { triangle.Positions[0], glm::dvec3(1.0, 0.0, 0.0) },
    { triangle.Positions[1], glm::dvec3(0.0, 1.0, 0.0) },
    { triangle.Positions[2], glm::dvec3(0.0, 0.0, 1.0) } };
  parts.clear();
  this->FindParts(polygon, parts);
}

} // namespace bravais
