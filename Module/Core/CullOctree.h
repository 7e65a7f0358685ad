// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CullOctree_h
#define CullOctree_h

#include "CellGrid.h"
#include "GixelOctree.h"
#include "VolumeTest.h"

#include <cstdint>
#include <vector>

namespace bravais
{

/// A node of an octree.
struct OctreeNode
{
  int Depth;
  std::uint32_t Index;
};

/// What of an octree a volume meets: nodes that are wholly inside, none of them below another, and
/// leaves that are partly so.
struct CullResult
{
  std::vector<OctreeNode> Inside;
  std::vector<std::uint32_t> Partly;
  std::vector<std::uint64_t> Pending; // what the test left of each of these
};

/// Tests the octree's cells from the root down; the search ends at cells inside and outside.
void CullOctree(
  const GixelOctree& tree, const CellGrid& grid, const VolumeTest& volume, CullResult& result);

/// How many leaves a result has.
std::uint64_t CountLeaves(const GixelOctree& tree, const CullResult& result);

/// The cells of another octree's leaves as a volume.
class LeavesTest : public VolumeTest
{
public:
  LeavesTest(const GixelOctree& tree, const CellGrid& grid);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const override;

private:
  const GixelOctree& Tree;
  const CellGrid& Grid;
};

/// A straight line from one point to another, ends included: cells it passes through or touches are
/// partly in it, and a point is not.
class SegmentTest : public VolumeTest
{
public:
  SegmentTest(const glm::dvec3& from, const glm::dvec3& to);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& /*point*/, std::uint64_t /*pending*/) const override
  {
    return false;
  }

  /// Whether the line meets a closed box before a part of its length.
  bool Meets(const Box& box, double before) const;

private:
  glm::dvec3 From;
  glm::dvec3 Along;
};

} // namespace bravais

#endif
