// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParametricSurface.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace bravais
{

//------------------------------------------------------------------------------
double GetSymmetricParameter(std::int64_t i, std::int64_t n)
{
  return n > 1 ? static_cast<double>(2 * i - (n - 1)) / static_cast<double>(n - 1) : 0.0;
}

//------------------------------------------------------------------------------
glm::dvec3 FoldOctahedron(const glm::dvec2& uv)
{
  const double z = 1.0 - std::abs(uv.x) - std::abs(uv.y);
  if (z >= 0.0)
  {
    return glm::dvec3(uv, z);
  }
  return { std::copysign(1.0 - std::abs(uv.y), uv.x), std::copysign(1.0 - std::abs(uv.x), uv.y),
    z };
}

//------------------------------------------------------------------------------
glm::dvec3 FoldSphere(const glm::dvec2& uv)
{
  // Adding 0 turns -0, which an edge folded on itself has on one side, into 0.
  return glm::normalize(FoldOctahedron(uv)) + 0.0;
}

//------------------------------------------------------------------------------
double GetBumpyRadius(const glm::dvec3& direction, double amplitude, double frequency)
{
  const glm::dvec3 phase = glm::pi<double>() * frequency * direction;
  return 1.0 + amplitude * std::sin(phase.x) * std::sin(phase.y) * std::sin(phase.z);
}

//------------------------------------------------------------------------------
glm::dvec3 GetTorusPoint(const glm::dvec2& turns, double ringRadius, double crossSectionRadius)
{
  const glm::dvec2 angle = glm::two_pi<double>() * turns;
  const double distance = ringRadius + crossSectionRadius * std::cos(angle.y);
  return { distance * std::cos(angle.x), distance * std::sin(angle.x),
    crossSectionRadius * std::sin(angle.y) };
}

} // namespace bravais
