// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FoldedCut_h
#define FoldedCut_h

#include "FoldedSquare.h"
#include "TriangleTopology.h"

#include <glm/vec3.hpp>

#include <vector>

namespace bravais
{

/// A tree of edges that joins four vertices of a closed mesh, the tips. Cut along it the mesh is a
/// disk, and round that disk the tips come in some order: they are at the folds of the rectangle in
/// that order. A vertex on the tree is at several places of the disk's rim, which half turns about
/// the folds map to each other.
struct FoldedCut
{
  std::array<int, 4> Tips{};     // in the order of the folds
  std::vector<HalfTurn> Corners; // of each half-edge: from the place of its origin to its own place
};

/// Distances along edges from some vertices, and the edge by which each vertex was reached, -1 at
/// the former.
struct EdgeDistances
{
  std::vector<double> Distances;
  std::vector<int> HalfEdges; // towards the vertex
};
EdgeDistances FindEdgeDistances(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points,
  const std::vector<int>& sources);

/// Four vertices far from each other, the first two farthest, and so on.
std::array<int, 4> FindTips(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points);

/// Cuts along the shortest ways from `root` to the tips.
FoldedCut CutToTips(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points, int root,
  const std::array<int, 4>& tips, const glm::dvec2& size);

} // namespace bravais

#endif
