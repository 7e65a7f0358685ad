// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DiskRim_h
#define DiskRim_h

/// \file
/// How the boundary of a disk, its rim, becomes that of a rectangle.

#include "SurfaceParameters.h"

#include <array>
#include <vector>

namespace bravais
{

using Ends = std::array<int, 2>;

/// Four vertices of the rim, in its order: those at which it turns most on the surface, a twelfth
/// of its length apart, if it turns by 30 degrees at the fourth; else quarters of its length from
/// where it turns most. The one of the least number comes first. The rim has at least four
/// vertices.
std::array<int, 4> FindRimCorners(
  const TriangleTopology& mesh, const std::vector<glm::dvec3>& points);

/// Edges inside the disk whose ends are on the same side of the rectangle: between them and the
/// side nothing would be left for triangles.
std::vector<Ends> FindChords(const TriangleTopology& mesh, const std::array<int, 4>& corners);

/// The triangles, each split where edges of it are. The middle of edges[n] has the number
/// mesh.GetNumberOfVertices() + n.
std::vector<Triangle> SplitEdges(const TriangleTopology& mesh, const std::vector<Ends>& edges);

/// The rim along the rectangle's sides, by lengths, from the corner at (0, 0) anticlockwise.
SurfaceParameters LayRim(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points,
  const std::array<int, 4>& corners, const glm::dvec2& size);

} // namespace bravais

#endif
