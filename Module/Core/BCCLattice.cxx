// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCLattice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bravais
{

glm::ivec3 BCCLattice::FindNearest(const glm::dvec3& position)
{
  // Each coset is a cubic grid of spacing 2, in which rounding finds the nearest point.
  const glm::dvec3 even = 2.0 * glm::floor(0.5 * position + 0.5);
  const glm::dvec3 odd = 2.0 * glm::floor(0.5 * position) + 1.0;
  const glm::dvec3 toEven = position - even;
  const glm::dvec3 toOdd = position - odd;
  return glm::dot(toOdd, toOdd) < glm::dot(toEven, toEven) ? glm::ivec3(odd) : glm::ivec3(even);
}

} // namespace bravais
