// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleSearch_h
#define TriangleSearch_h

#include "CullOctree.h"
#include "GixelOctree.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace bravais
{

/**
 * The triangles of a geometry image, found by the octree of its gixels. Four gixels (i, j),
 * (i + 1, j), (i, j + 1), (i + 1, j + 1) that are all used are two triangles, split along the
 * shorter diagonal, and three used ones are one. A triangle reaches beyond the cell of any of its
 * gixels, so each node has the box of the triangles that belong to it: to the leaf of the first
 * gixel, in that order, which has one.
 */
class TriangleSearch
{
public:
  using Positions = std::function<glm::dvec3(std::uint32_t gixel)>;
  using Triangle = std::array<std::uint32_t, 3>;

  /// Where a line meets the surface.
  struct Hit
  {
    double Parameter; // 0 .. 1 along the line
    glm::dvec3 Point;
    Triangle Gixels;
    glm::dvec3 Weights; // of the three, that sum to 1
  };

  /// Of the gixels that are in the tree. The tree has to outlive this.
  TriangleSearch(
    const GixelOctree& tree, std::uint32_t width, std::uint32_t height, const Positions& positions);

  /// The first triangle that the line meets, seen from either side, its ends included.
  std::optional<Hit> Intersect(
    const glm::dvec3& from, const glm::dvec3& to, const Positions& positions) const;

private:
  /// Up to two triangles of the four gixels whose first is at a place.
  int GetTriangles(
    std::uint32_t corner, const Positions& positions, std::array<Triangle, 2>& triangles) const;
  void AddToLeaf(std::uint32_t corner, const Positions& positions);
  bool IsOwner(std::uint32_t gixel, std::uint32_t corner) const;

  const GixelOctree& Tree;
  std::uint32_t Width;
  std::uint32_t Height;
  std::vector<std::uint32_t> LeafOf;   // of each gixel, or CellGrid::NoCell
  std::vector<std::vector<Box>> Boxes; // of each depth's nodes
};

} // namespace bravais

#endif
