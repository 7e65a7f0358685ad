// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelLevel.h"

namespace bravais
{

namespace
{

/// First and last gixel of a kept one's region.
struct Span
{
  Span(const GixelLine& line, int n)
    : First(n > 0 ? line[n - 1] + 1 : 0)
    , Last(n + 1 < line.Count() ? line[n + 1] - 1 : line[n])
  {
  }
  int First;
  int Last;
};

} // namespace

//------------------------------------------------------------------------------
std::vector<unsigned char> DownSampleMask(const unsigned char* mask, const GixelLevel& level)
{
  const int columns = level.Columns.Count();
  const int rows = level.Rows.Count();
  const auto width = static_cast<std::size_t>(level.Width);
  std::vector<unsigned char> result;
  result.reserve(static_cast<std::size_t>(level.Count()));
  std::vector<unsigned char> any(width);
  for (int row = 0; row < rows; ++row)
  {
    std::fill(any.begin(), any.end(), static_cast<unsigned char>(0));
    const Span span(level.Rows, row);
    for (int y = span.First; y <= span.Last; ++y)
    {
      const unsigned char* from = mask + static_cast<std::size_t>(y) * width;
      for (std::size_t x = 0; x < width; ++x)
      {
        any[x] = static_cast<unsigned char>(any[x] | from[x]);
      }
    }
    for (int column = 0; column < columns; ++column)
    {
      const Span part(level.Columns, column);
      result.push_back(std::any_of(any.begin() + part.First, any.begin() + part.Last + 1,
        [](unsigned char bit) { return bit != 0; }));
    }
  }
  return result;
}

} // namespace bravais
