// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCFit.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace bravais
{
namespace
{

/// How many points have room, as floating-point numbers without a limit. A unit that was computed
/// to fit exactly has to fit.
glm::dvec3 CountPoints(const glm::dvec3& edges, double unit)
{
  const glm::dvec3 room = edges / unit * (1.0 + 1e-12);
  return { std::floor(0.5 * room.x + 0.5), std::floor(0.5 * room.y + 0.5),
    std::floor(room.z) + 1.0 };
}

double Product(const glm::dvec3& v)
{
  return v.x * v.y * v.z;
}

} // namespace

glm::dvec3 GetBCCEdges(const glm::ivec3& dimensions)
{
  return glm::dvec3(dimensions) * glm::dvec3(2.0, 2.0, 1.0) - 1.0;
}

double FitBCCUnit(const glm::dvec3& edges, const glm::ivec3& dimensions)
{
  const glm::dvec3 units = edges / GetBCCEdges(dimensions);
  return std::min({ units.x, units.y, units.z });
}

std::optional<BCCFit> FitBCC(const glm::dvec3& edges, double count)
{
  constexpr double most = 1073741824.0;
  const bool usable = edges.x > 0.0 && edges.y > 0.0 && edges.z > 0.0 && count > 0.0;
  if (!usable || !std::isfinite(count) || !std::isfinite(Product(edges)))
  {
    return std::nullopt;
  }
  // The number of points falls in steps as the unit grows. Between these two it passes `count`.
  double fine = std::min({ edges.x, edges.y, edges.z });
  double coarse = 2.0 * std::max({ edges.x, edges.y, edges.z });
  while (Product(CountPoints(edges, fine)) < count)
  {
    fine *= 0.5;
  }
  for (int step = 0; step < 200 && fine < coarse; ++step)
  {
    const double middle = 0.5 * (fine + coarse);
    (Product(CountPoints(edges, middle)) < count ? coarse : fine) = middle;
  }
  const glm::dvec3 more = CountPoints(edges, fine);
  const glm::dvec3 less = CountPoints(edges, coarse);
  const bool lessIsUsable = less.x >= 1.0 && less.y >= 1.0 && less.z >= 2.0;
  const glm::dvec3 best =
    lessIsUsable && count - Product(less) < Product(more) - count ? less : more;
  if (best.x < 1.0 || best.y < 1.0 || best.z < 2.0 ||
    glm::any(glm::greaterThan(best, glm::dvec3(most))))
  {
    return std::nullopt;
  }
  const glm::ivec3 dimensions(best);
  return BCCFit{ dimensions, FitBCCUnit(edges, dimensions) };
}

} // namespace bravais
