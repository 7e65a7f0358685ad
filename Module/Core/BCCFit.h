// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCFit_h
#define BCCFit_h

#include <glm/vec3.hpp>

#include <optional>

namespace bravais
{

/// An isotropic BCC lattice that fits a box.
struct BCCFit
{
  glm::ivec3 Dimensions; ///< nx, ny, nk
  double Unit;           ///< length of one lattice coordinate: spacing 2 Unit, 2 Unit, Unit
};

/// The box's edges that a lattice of those dimensions has, in lattice coordinates: 2 nx - 1,
/// 2 ny - 1, nk - 1.
glm::dvec3 GetBCCEdges(const glm::ivec3& dimensions);

/// The largest unit for which a lattice of given dimensions, at least 1 x 1 x 2, is not larger than
/// a box of given edges.
double FitBCCUnit(const glm::dvec3& edges, const glm::ivec3& dimensions);

/// The lattice with as nearly as possible `count` points that fits a box of given positive edges:
/// along each axis as many points as have room, so that less than a step is left over, and along
/// one of them nothing. None if count or an edge is not positive and finite, if that is less than
/// 1 x 1 x 2 points, or if a dimension is more than 2^30.
std::optional<BCCFit> FitBCC(const glm::dvec3& edges, double count);

} // namespace bravais

#endif
