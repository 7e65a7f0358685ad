// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickDistances.h"

#include <algorithm>
#include <cstddef>

namespace bravais
{
namespace
{

/// Lets every brick of a row be at most one further than its neighbours in another row.
void Spread(const std::uint8_t* other, std::uint8_t* row, int count)
{
  for (int x = 0; x < count; ++x)
  {
    const int nearest =
      std::min({ other[std::max(x - 1, 0)], other[x], other[std::min(x + 1, count - 1)] });
    row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], nearest + 1));
  }
}

/// The same from the neighbour before, one after the other.
void SpreadAlong(std::uint8_t* row, int count, int first, int step)
{
  for (int n = 1, x = first + step; n < count; ++n, x += step)
  {
    row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], row[x - step] + 1));
  }
}

} // namespace

//------------------------------------------------------------------------------
void FindBrickDistances(const glm::ivec3& size, std::vector<std::uint8_t>& bricks)
{
  for (std::uint8_t& brick : bricks)
  {
    brick = brick != 0 ? 0 : 255;
  }
  const auto row = [&](int y, int z)
  {
    return bricks.data() +
      static_cast<std::size_t>(size.x) *
      (static_cast<std::size_t>(size.y) * static_cast<std::size_t>(z) +
        static_cast<std::size_t>(y));
  };
  for (const int step : { 1, -1 })
  {
    const glm::ivec3 first = step > 0 ? glm::ivec3(0) : size - 1;
    for (int k = 0, z = first.z; k < size.z; ++k, z += step)
    {
      for (int j = 0, y = first.y; j < size.y; ++j, y += step)
      {
        for (int dy = -1; k > 0 && dy <= 1; ++dy)
        {
          if (y + dy >= 0 && y + dy < size.y)
          {
            Spread(row(y + dy, z - step), row(y, z), size.x);
          }
        }
        if (j > 0)
        {
          Spread(row(y - step, z), row(y, z), size.x);
        }
        SpreadAlong(row(y, z), size.x, first.x, step);
      }
    }
  }
}

//------------------------------------------------------------------------------
void FindSignedBrickDistances(const glm::ivec3& size, std::vector<std::uint8_t>& bricks)
{
  std::vector<std::uint8_t> toUnmarked = bricks;
  for (std::uint8_t& brick : toUnmarked)
  {
    brick = brick == 0 ? 1 : 0;
  }
  FindBrickDistances(size, toUnmarked);
  FindBrickDistances(size, bricks);
  for (std::size_t n = 0; n < bricks.size(); ++n)
  {
    bricks[n] = static_cast<std::uint8_t>(
      128 + std::min<int>(bricks[n], 127) - std::min<int>(toUnmarked[n], 128));
  }
}

} // namespace bravais
