// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelTriangles_h
#define GixelTriangles_h

/// \file
/// The triangles between the gixels that a level of detail keeps. A cell has the corners
///
///   c d
///   a b     with b one column after a, c one row after it
///
/// and is split along the shorter of a d and b c, along a d where they are equally long; its
/// triangles are a b d and a d c, or a b c and b d c. Where one corner is unused, the other three
/// are a triangle. Corners are in the order that turns from columns to rows.

#include "GixelLevel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bravais
{

/// Places of an image's gixels, and which of them are used: nullptr stands for all.
template <class T>
struct GixelGrid
{
  const T* Points;
  const unsigned char* Used;
  int Width;
  int Height;

  std::int64_t Index(int column, int row) const
  {
    return std::int64_t{ row } * this->Width + column;
  }
  bool IsUsed(int column, int row) const
  {
    return !this->Used || this->Used[this->Index(column, row)];
  }
};

/// Which triangles a cell has, as bits of a byte.
inline constexpr unsigned FirstTriangle = 1;
inline constexpr unsigned SecondTriangle = 2;
inline constexpr unsigned SplitBC = 4;

using GixelTriangle = std::array<std::int64_t, 3>;

/// Numbers of the level's gixels at a cell's corners.
inline GixelTriangle GetGixelTriangle(
  std::int64_t a, std::int64_t columns, bool splitBC, bool second)
{
  const std::int64_t b = a + 1;
  const std::int64_t c = a + columns;
  const std::int64_t d = c + 1;
  if (splitBC)
  {
    return second ? GixelTriangle{ b, d, c } : GixelTriangle{ a, b, c };
  }
  return second ? GixelTriangle{ a, d, c } : GixelTriangle{ a, b, d };
}

/// The cells of one row of a level, a byte each, and how many triangles they have. A
/// triangle is made if its corners and all gixels that it covers are used, and one of its corners
/// is set in `mask`, of the level's gixels, or that is nullptr.
template <class T>
std::int64_t ClassifyGixelCells(const GixelGrid<T>& grid, const GixelLevel& level,
  const unsigned char* mask, int row, unsigned char* cells);

/// Triangle strips of one row of cells: `lengths` of them and the gixels' numbers, appended.
void AppendGixelStrips(const unsigned char* cells, std::int64_t columns, int row,
  std::vector<std::int64_t>& lengths, std::vector<std::int64_t>& gixels);

} // namespace bravais

#endif
