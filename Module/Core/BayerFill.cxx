// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerFill.h"

#include "BayerPattern.h"

#include <tuple>

namespace bravais
{
namespace
{

/// The shortest of the steps d + k n, on the longer side of which there is another square.
int Shorten(int step, int size)
{
  const int half = size / 2;
  return step > half ? step - size : (step < -half ? step + size : step);
}

} // namespace

std::vector<glm::ivec2> GetNearestFirstCells(const BayerPattern& pattern, std::int64_t count)
{
  const int size = static_cast<int>(pattern.GetSize());
  std::vector<glm::ivec2> first;
  for (std::int64_t rank = 0; rank < count; ++rank)
  {
    const glm::ivec3 cell = pattern.GetCell(rank);
    first.emplace_back(cell.x, cell.y);
  }
  std::vector<glm::ivec2> steps;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      glm::ivec2 best(size, size);
      auto order = std::make_tuple(2 * size * size, true);
      for (const glm::ivec2& other : first)
      {
        const glm::ivec2 step(Shorten(other.x - x, size), Shorten(other.y - y, size));
        const bool outside = x + step.x != other.x || y + step.y != other.y;
        const auto candidate = std::make_tuple(step.x * step.x + step.y * step.y, outside);
        if (candidate < order)
        {
          order = candidate;
          best = step;
        }
      }
      steps.push_back(best);
    }
  }
  return steps;
}

} // namespace bravais
