// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalityQuery.h"

#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkImplicitFunction.h"

#include <algorithm>
#include <chrono>

namespace bravais
{

namespace
{

/// Writes 1 for those gixels of a node that are inside.
template <class F>
void PaintGixels(
  const GixelOctree& tree, const OctreeNode& node, const F& inside, std::uint8_t* mask)
{
  const std::vector<std::uint32_t>& places = tree.GetLevel(node.Depth).Gixels;
  for (std::uint32_t n = places[node.Index]; n < places[node.Index + 1]; ++n)
  {
    const std::uint32_t gixel = tree.GetGixels()[n];
    mask[gixel] = inside(gixel) ? 1 : 0;
  }
}

} // namespace

//------------------------------------------------------------------------------
void LocalityQuery::Paint(
  const GeometryHierarchy& hierarchy, const OctreeNode& node, std::uint8_t* mask)
{
  // A node's gixels may be written one by one, or its mask's code run by run: the latter is sooner
  // done where runs are long, as they are in large nodes.
  constexpr std::ptrdiff_t gixelsAByte = 8; // written while a byte of a code is read
  const GixelOctree& tree = hierarchy.GetTree();
  const std::vector<std::uint32_t>& places = tree.GetLevel(node.Depth).Gixels;
  const std::ptrdiff_t gixels = places[node.Index + 1] - places[node.Index];
  bool byRuns = false;
  if (hierarchy.GetMasks().Has(node.Depth))
  {
    const MaskStore::Code code = hierarchy.GetMasks().Get(node.Depth, node.Index);
    byRuns = gixelsAByte * (code.End - code.Begin) < gixels;
  }
  if (byRuns)
  {
    hierarchy.GetMasks().Paint(node.Depth, node.Index, mask);
  }
  else
  {
    PaintGixels(
      tree, node, [](std::uint32_t) { return true; }, mask);
  }
}

//------------------------------------------------------------------------------
std::uint64_t LocalityQuery::GetSize(const GeometryHierarchy& hierarchy) const
{
  const GixelOctree& tree = hierarchy.GetTree();
  std::uint64_t size = 0;
  const auto add = [&](int depth, std::uint32_t node)
  {
    const MaskStore::Code code = hierarchy.GetMasks().Get(depth, node);
    size += static_cast<std::uint64_t>(code.End - code.Begin);
  };
  for (const OctreeNode& node : this->Result.Inside)
  {
    if (hierarchy.GetMasks().Has(node.Depth))
    {
      add(node.Depth, node.Index);
      continue;
    }
    const std::uint32_t end = tree.GetFirstLeaf(node.Depth, node.Index + 1);
    for (std::uint32_t leaf = tree.GetFirstLeaf(node.Depth, node.Index); leaf < end; ++leaf)
    {
      add(tree.GetDepth(), leaf);
    }
  }
  for (const std::uint32_t leaf : this->Result.Partly)
  {
    add(tree.GetDepth(), leaf);
  }
  return size;
}

//------------------------------------------------------------------------------
bool LocalityQuery::FindLeaves(vtkAlgorithm* self, const GeometryHierarchy& hierarchy,
  const GixelView& gixels, vtkImplicitFunction* function, double begin)
{
  const GixelOctree& tree = hierarchy.GetTree();
  this->Inside.assign(static_cast<std::size_t>(gixels.GetNumberOfGixels()), 0);
  // Functions need not be safe to call from several threads.
  const auto row = [&](int j)
  {
    for (vtkIdType gixel = j * gixels.GetWidth(); gixel < (j + 1) * gixels.GetWidth(); ++gixel)
    {
      if (gixels.IsUsed(gixel))
      {
        double x[3];
        gixels.GetPoint(gixel, x);
        this->Inside[static_cast<std::size_t>(gixel)] = function->FunctionValue(x) < 0.0;
      }
    }
  };
  const int last = static_cast<int>(gixels.GetHeight()) - 1;
  if (!ForEachSliceInOrder(self, 0, last, row, begin, 0.5 + 0.5 * begin))
  {
    return false;
  }
  const GixelOctree::Level& leaves = tree.GetLeaves();
  for (std::uint32_t leaf = 0; leaf < leaves.GetSize(); ++leaf)
  {
    const auto* first = tree.GetGixels().data() + leaves.Gixels[leaf];
    const auto* end = tree.GetGixels().data() + leaves.Gixels[leaf + 1];
    if (std::any_of(first, end, [&](std::uint32_t gixel) { return this->Inside[gixel] != 0; }))
    {
      this->Result.Partly.push_back(leaf);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool LocalityQuery::Execute(vtkAlgorithm* self, const GeometryHierarchy& hierarchy,
  const GixelView& gixels, const CullVolume& volume, bool refine, double begin, std::uint8_t* mask)
{
  this->Result.Inside.clear();
  this->Result.Partly.clear();
  this->Leaves = 0;
  this->CullTime = 0.0;
  this->UnionTime = 0.0;
  self->UpdateProgress(begin);
  const GixelOctree& tree = hierarchy.GetTree();
  if (!hierarchy.GetGrid())
  {
    self->UpdateProgress(1.0);
    return !self->GetAbortExecute(); // no gixel is used
  }
  const auto start = std::chrono::steady_clock::now();
  if (volume.Test)
  {
    CullOctree(tree, *hierarchy.GetGrid(), *volume.Test, this->Result);
  }
  else if (volume.Function)
  {
    if (!this->FindLeaves(self, hierarchy, gixels, volume.Function, begin))
    {
      return false;
    }
  }
  else if (tree.GetLevel(0).GetSize())
  {
    this->Result.Inside.push_back({ 0, 0 });
  }
  const auto found = std::chrono::steady_clock::now();
  this->CullTime = std::chrono::duration<double>(found - start).count();
  self->UpdateProgress(0.4 * begin + 0.6);
  this->Leaves = CountLeaves(tree, this->Result);
  const int depth = tree.GetDepth();
  for (const OctreeNode& node : this->Result.Inside)
  {
    this->Paint(hierarchy, node, mask);
  }
  self->UpdateProgress(0.2 * begin + 0.8);
  for (std::size_t n = 0; n < this->Result.Partly.size(); ++n)
  {
    const std::uint32_t leaf = this->Result.Partly[n];
    if (!refine)
    {
      this->Paint(hierarchy, { depth, leaf }, mask);
    }
    else if (!volume.Test)
    {
      PaintGixels(
        tree, { depth, leaf }, [&](std::uint32_t g) { return this->Inside[g] != 0; }, mask);
    }
    else
    {
      const std::uint64_t pending = this->Result.Pending[n];
      const auto inside = [&](std::uint32_t gixel)
      {
        glm::dvec3 x;
        gixels.GetPoint(gixel, &x.x);
        return volume.Function ? volume.Function->FunctionValue(&x.x) < 0.0
                               : volume.Test->Contains(x, pending);
      };
      PaintGixels(tree, { depth, leaf }, inside, mask);
    }
  }
  this->UnionTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - found).count();
  self->UpdateProgress(1.0);
  return !self->GetAbortExecute();
}

} // namespace bravais
