// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace bravais
{

namespace
{

constexpr double SmallestEdge = 1e-290; // cells well above the least of all numbers

/// Spreads 10 bits to every third, and gathers them again.
std::uint32_t Spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000ffU;
  bits = (bits | bits << 8) & 0x0300f00fU;
  bits = (bits | bits << 4) & 0x030c30c3U;
  return (bits | bits << 2) & 0x09249249U;
}

int Gather(std::uint32_t bits)
{
  bits &= 0x09249249U;
  bits = (bits | bits >> 2) & 0x030c30c3U;
  bits = (bits | bits >> 4) & 0x0300f00fU;
  bits = (bits | bits >> 8) & 0x030000ffU;
  return static_cast<int>((bits | bits >> 16) & 0x3ffU);
}

/// Numbers as integers of the same order, so that halving finds one among them.
std::int64_t ToOrdinal(double x)
{
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

double FromOrdinal(std::int64_t ordinal)
{
  const std::int64_t bits =
    ordinal < 0 ? std::numeric_limits<std::int64_t>::min() - ordinal : ordinal;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

double GetLargest(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

} // namespace

//------------------------------------------------------------------------------
std::uint32_t ToMorton(const glm::ivec3& cell)
{
  return Spread(static_cast<std::uint32_t>(cell.x)) << 2 |
    Spread(static_cast<std::uint32_t>(cell.y)) << 1 | Spread(static_cast<std::uint32_t>(cell.z));
}

//------------------------------------------------------------------------------
glm::ivec3 FromMorton(std::uint32_t code)
{
  return { Gather(code >> 2), Gather(code >> 1), Gather(code) };
}

//------------------------------------------------------------------------------
std::optional<CellGrid> CellGrid::Create(const glm::dvec3& corner, double edge, int depth)
{
  // Cells have to be wider than the numbers' own distance at the cube's far end.
  const double finest = std::numeric_limits<double>::epsilon() * (GetLargest(corner) + edge);
  const double least = std::max(std::ldexp(finest, MaximumDepth + 2), SmallestEdge);
  const bool good = depth >= 0 && depth <= MaximumDepth && std::isfinite(finest) && edge > least;
  return good ? std::optional<CellGrid>(CellGrid(corner, edge, depth)) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<CellGrid> CellGrid::CreateRound(const Box& box, int depth)
{
  constexpr double margin = 1e-6;
  const glm::dvec3 center = 0.5 * box.Low + 0.5 * box.High;
  const double edge = GetLargest(box.High - box.Low) * (1.0 + margin);
  const double least = std::max(margin * margin * GetLargest(center), SmallestEdge);
  const double used = edge > least ? edge : std::max(margin * GetLargest(center), margin);
  return Create(center - 0.5 * used, used, depth);
}

//------------------------------------------------------------------------------
CellGrid::CellGrid(const glm::dvec3& corner, double edge, int depth)
  : Corner(corner)
  , Edge(edge)
  , Depth(depth)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int cell = 0; cell <= 1 << depth; ++cell)
    {
      this->Boundaries.push_back(this->FindBoundary(axis, cell));
    }
  }
}

//------------------------------------------------------------------------------
double CellGrid::GetCell(int axis, double x) const
{
  return std::floor(std::ldexp((x - this->Corner[axis]) / this->Edge, this->Depth));
}

//------------------------------------------------------------------------------
double CellGrid::FindBoundary(int axis, int cell) const
{
  const double guess = this->Corner[axis] + std::ldexp(this->Edge, -this->Depth) * cell;
  double reach =
    4.0 * std::numeric_limits<double>::epsilon() * (std::abs(this->Corner[axis]) + this->Edge);
  while (this->GetCell(axis, guess - reach) >= cell || this->GetCell(axis, guess + reach) < cell)
  {
    reach *= 2.0;
  }
  std::int64_t below = ToOrdinal(guess - reach);
  std::int64_t above = ToOrdinal(guess + reach);
  while (above - below > 1)
  {
    const std::int64_t middle = below + (above - below) / 2;
    (this->GetCell(axis, FromOrdinal(middle)) < cell ? below : above) = middle;
  }
  return FromOrdinal(above);
}

//------------------------------------------------------------------------------
std::uint32_t CellGrid::GetCode(const glm::dvec3& point) const
{
  // The same numbers as GetCell's: a product with a power of two does not round.
  const double cells = static_cast<double>(1 << this->Depth);
  const glm::dvec3 at = (point - this->Corner) / this->Edge * cells;
  if (!(at.x >= 0.0 && at.x < cells && at.y >= 0.0 && at.y < cells && at.z >= 0.0 && at.z < cells))
  {
    return NoCell;
  }
  return ToMorton(glm::ivec3(at)); // truncation, as all are at least 0
}

} // namespace bravais
