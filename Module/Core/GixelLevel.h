// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelLevel_h
#define GixelLevel_h

/// \file
/// Level of detail l of a geometry image: every 2^l-th gixel of every 2^l-th row, and always the
/// last of a row and the last row, so that the border stays where it is.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bravais
{

/// The gixels that a level keeps along one direction of an image.
class GixelLine
{
public:
  static constexpr int MaximumLevel = 30;

  GixelLine(int size, int level)
    : Last(size - 1)
    , Stride(1 << std::clamp(level, 0, MaximumLevel))
  {
  }

  /// How many are kept.
  int Count() const { return this->Last / this->Stride + (this->Last % this->Stride != 0) + 1; }

  /// Index in the image of a kept one.
  int operator[](int n) const
  {
    const std::int64_t index = std::int64_t{ n } * this->Stride;
    return index < this->Last ? static_cast<int>(index) : this->Last;
  }

private:
  int Last;
  int Stride;
};

/// The gixels that a level keeps, in rows, numbered row by row.
struct GixelLevel
{
  GixelLevel(int width, int height, int level)
    : Width(width)
    , Height(height)
    , Columns(width, level)
    , Rows(height, level)
  {
  }

  std::int64_t Count() const { return std::int64_t{ this->Columns.Count() } * this->Rows.Count(); }

  int Width;
  int Height;
  GixelLine Columns;
  GixelLine Rows;
};

/// A mask of an image's gixels, one byte each, for a level: a kept gixel is set where any is that
/// lies between its neighbours, those two excluded, along both directions. So every set gixel of
/// the image has a set corner in every triangle of the level that it lies in.
std::vector<unsigned char> DownSampleMask(const unsigned char* mask, const GixelLevel& level);

} // namespace bravais

#endif
