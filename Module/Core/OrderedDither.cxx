// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OrderedDither.h"

#include <cmath>

namespace bravais
{

std::optional<OrderedDither> OrderedDither::Create(
  const BayerPattern& pattern, int levels, double lo, double hi)
{
  if (levels < 2 || levels > MaximumLevels ||
    pattern.GetLog2NumberOfCells() > MaximumLog2NumberOfCells || !(lo < hi) ||
    !std::isfinite(hi - lo))
  {
    return std::nullopt;
  }
  return OrderedDither(pattern, levels, lo, hi);
}

OrderedDither::OrderedDither(const BayerPattern& pattern, int levels, double lo, double hi)
  : Pattern(pattern)
  , Low(lo)
  , Scale(static_cast<double>((levels - 1) * pattern.GetNumberOfCells()) / (hi - lo))
  , Highest(static_cast<double>((levels - 1) * pattern.GetNumberOfCells()))
{
}

} // namespace bravais
