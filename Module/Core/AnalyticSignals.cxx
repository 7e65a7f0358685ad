// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticSignals.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace bravais
{

double MarschnerLobb(const glm::dvec3& x, double alpha, double frequency)
{
  constexpr double pi = glm::pi<double>();
  const double r = glm::length(glm::dvec2(x));
  const double rho = std::cos(2.0 * pi * frequency * std::cos(0.5 * pi * r));
  return (1.0 - std::sin(0.5 * pi * x.z) + alpha * (1.0 + rho)) / (2.0 * (1.0 + alpha));
}

double Gaussian(const glm::dvec3& x, double deviation)
{
  return std::exp(-0.5 * glm::dot(x, x) / (deviation * deviation));
}

} // namespace bravais
