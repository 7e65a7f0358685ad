// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ParametricSurface_h
#define ParametricSurface_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace bravais
{

/// Where grid line i of n lies on -1 .. 1, antisymmetric to the last bit; 0 if there is but one.
double GetSymmetricParameter(std::int64_t i, std::int64_t n);

/// Point of the octahedron |x| + |y| + |z| = 1 that the square -1 .. 1 is folded round: the middle
/// diamond is the upper half, the corners are the lower, and each edge of the square folds on
/// itself about its midpoint. (u, v) runs anticlockwise seen from outside. E. Praun, H. Hoppe,
/// "Spherical parametrization and remeshing", SIGGRAPH 2003.
glm::dvec3 FoldOctahedron(const glm::dvec2& uv);

/// Direction from the centre of the unit sphere: the octahedron's point, normalised.
glm::dvec3 FoldSphere(const glm::dvec2& uv);

/// How far beyond the unit sphere a bumpy one reaches in a direction: 1 + amplitude times the
/// product of three sines of so many half waves a radius, one an axis.
double GetBumpyRadius(const glm::dvec3& direction, double amplitude, double frequency);

/// Torus about the z-axis; both angles in turns, 0 .. 1.
glm::dvec3 GetTorusPoint(const glm::dvec2& turns, double ringRadius, double crossSectionRadius);

} // namespace bravais

#endif
