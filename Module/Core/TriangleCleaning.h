// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleCleaning_h
#define TriangleCleaning_h

#include "TriangleTopology.h"

#include <glm/vec3.hpp>

namespace bravais
{

/// Gives corners that are at the same place, to the last bit, the number of the first of them.
void MergeCoincidentPoints(const std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles);

/// Removes, in order, triangles with a corner twice, and those with the same three corners as an
/// earlier one, whatever their sense.
void RemoveRepeatedTriangles(std::vector<Triangle>& triangles);

} // namespace bravais

#endif
