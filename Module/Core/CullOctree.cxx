// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CullOctree.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bravais
{

namespace
{

/// A node that is yet to be looked at, with the coordinates of its cell.
struct Visit
{
  OctreeNode Node;
  glm::ivec3 Cell;
  std::uint64_t Pending;
};

/// Nodes in depth-first order: at each depth fewer than eight are left, and eight are added.
class Visits
{
public:
  explicit Visits(const GixelOctree& tree)
    : Tree(tree)
  {
    if (tree.GetLevel(0).GetSize())
    {
      this->Stack[this->Size++] = { { 0, 0 }, glm::ivec3(0), VolumeTest::AllPending };
    }
  }

  bool Next(Visit& visit)
  {
    if (this->Size)
    {
      visit = this->Stack[--this->Size];
      return true;
    }
    return false;
  }

  void AddChildren(const Visit& parent)
  {
    const GixelOctree::Level& level = this->Tree.GetLevel(parent.Node.Depth);
    const GixelOctree::Level& below = this->Tree.GetLevel(parent.Node.Depth + 1);
    const std::uint32_t index = parent.Node.Index;
    for (std::uint32_t n = level.Children[index]; n < level.Children[index + 1]; ++n)
    {
      const std::uint32_t octant = below.Codes[n];
      const glm::ivec3 half(octant >> 2 & 1, octant >> 1 & 1, octant & 1);
      this->Stack[this->Size++] = { { parent.Node.Depth + 1, n }, parent.Cell * 2 + half,
        parent.Pending };
    }
  }

private:
  const GixelOctree& Tree;
  std::array<Visit, 8 * (CellGrid::MaximumDepth + 1)> Stack;
  std::size_t Size = 0;
};

bool AnyOf(const GixelOctree& tree, const CellGrid& grid, const Box& cell, bool& contained)
{
  Visits visits(tree);
  for (Visit visit; visits.Next(visit);)
  {
    const Box box = grid.GetBox(visit.Cell, visit.Node.Depth);
    bool overlap = true;
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      overlap = overlap && box.Low[axis] < cell.High[axis] && cell.Low[axis] < box.High[axis];
      within = within && box.Low[axis] <= cell.Low[axis] && cell.High[axis] <= box.High[axis];
    }
    if (overlap && visit.Node.Depth == tree.GetDepth())
    {
      contained = within;
      return true;
    }
    if (overlap)
    {
      visits.AddChildren(visit);
    }
  }
  return false;
}

} // namespace

//------------------------------------------------------------------------------
void CullOctree(
  const GixelOctree& tree, const CellGrid& grid, const VolumeTest& volume, CullResult& result)
{
  result.Inside.clear();
  result.Partly.clear();
  result.Pending.clear();
  Visits visits(tree);
  for (Visit visit; visits.Next(visit);)
  {
    const Box box = grid.GetBox(visit.Cell, visit.Node.Depth);
    const Overlap overlap = volume.Classify(box, visit.Pending);
    if (overlap == Overlap::Inside)
    {
      result.Inside.push_back(visit.Node);
    }
    else if (overlap == Overlap::Partly && visit.Node.Depth == tree.GetDepth())
    {
      result.Partly.push_back(visit.Node.Index);
      result.Pending.push_back(visit.Pending);
    }
    else if (overlap == Overlap::Partly)
    {
      visits.AddChildren(visit);
    }
  }
}

//------------------------------------------------------------------------------
std::uint64_t CountLeaves(const GixelOctree& tree, const CullResult& result)
{
  std::uint64_t leaves = result.Partly.size();
  for (const OctreeNode& node : result.Inside)
  {
    leaves +=
      tree.GetFirstLeaf(node.Depth, node.Index + 1) - tree.GetFirstLeaf(node.Depth, node.Index);
  }
  return leaves;
}

//------------------------------------------------------------------------------
LeavesTest::LeavesTest(const GixelOctree& tree, const CellGrid& grid)
  : Tree(tree)
  , Grid(grid)
{
}

//------------------------------------------------------------------------------
Overlap LeavesTest::Classify(const Box& cell, std::uint64_t& /*pending*/) const
{
  bool contained = false;
  if (!AnyOf(this->Tree, this->Grid, cell, contained))
  {
    return Overlap::Outside;
  }
  return contained ? Overlap::Inside : Overlap::Partly;
}

//------------------------------------------------------------------------------
bool LeavesTest::Contains(const glm::dvec3& point, std::uint64_t /*pending*/) const
{
  const std::vector<std::uint32_t>& codes = this->Tree.GetLeaves().Codes;
  return std::binary_search(codes.begin(), codes.end(), this->Grid.GetCode(point));
}

//------------------------------------------------------------------------------
SegmentTest::SegmentTest(const glm::dvec3& from, const glm::dvec3& to)
  : From(from)
  , Along(to - from)
{
}

//------------------------------------------------------------------------------
bool SegmentTest::Meets(const Box& box, double before) const
{
  double enter = 0.0;
  double leave = before;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.Low[axis] - this->From[axis];
    const double high = box.High[axis] - this->From[axis];
    if (this->Along[axis] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return false;
      }
      continue;
    }
    const double a = low / this->Along[axis];
    const double b = high / this->Along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  constexpr double rounding = 1e-14;
  return enter <= leave + rounding * (1.0 + std::abs(leave));
}

//------------------------------------------------------------------------------
Overlap SegmentTest::Classify(const Box& cell, std::uint64_t& /*pending*/) const
{
  return this->Meets(cell, 1.0) ? Overlap::Partly : Overlap::Outside;
}

} // namespace bravais
