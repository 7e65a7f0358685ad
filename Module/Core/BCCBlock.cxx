// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCBlock.h"

namespace bravais
{

bool IsEmpty(const BCCExtent& extent)
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

bool Contains(const BCCExtent& outer, const BCCExtent& inner)
{
  return outer[0] <= inner[0] && inner[1] <= outer[1] && outer[2] <= inner[2] &&
    inner[3] <= outer[3] && outer[4] <= inner[4] && inner[5] <= outer[5];
}

BCCExtent GrowWithin(const BCCExtent& whole, const BCCExtent& extent)
{
  BCCExtent grown = extent;
  for (int low = 0; low < 6; low += 2)
  {
    grown[low] -= grown[low] > whole[low] ? 1 : 0;
    grown[low + 1] += grown[low + 1] < whole[low + 1] ? 1 : 0;
  }
  return grown;
}

} // namespace bravais
