// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef AnalyticSignals_h
#define AnalyticSignals_h

#include <glm/vec3.hpp>

namespace bravais
{

/// The signal of Marschner and Lobb, "An Evaluation of Reconstruction Filters for Volume
/// Rendering", IEEE Visualization 1994:
///
///     (1 - sin(pi z / 2) + alpha (1 + rho(sqrt(x^2 + y^2)))) / (2 (1 + alpha)),
///     rho(r) = cos(2 pi frequency cos(pi r / 2)),
///
/// meant for the cube from -1 to 1, where its values are 0 to 1 for alpha >= 0.
double MarschnerLobb(const glm::dvec3& x, double alpha, double frequency);

/// exp(-|x|^2 / (2 deviation^2)): 1 at the origin, not normalised to an integral of 1.
double Gaussian(const glm::dvec3& x, double deviation);

} // namespace bravais

#endif
