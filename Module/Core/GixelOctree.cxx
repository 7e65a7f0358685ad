// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelOctree.h"

#include "CellGrid.h"

#include <algorithm>
#include <numeric>

namespace bravais
{

//------------------------------------------------------------------------------
GixelOctree::GixelOctree(const std::vector<std::uint32_t>& codes, int depth)
  : Levels(static_cast<std::size_t>(depth) + 1)
  , Size(static_cast<std::uint32_t>(codes.size()))
{
  this->SortByCode(codes, 3 * depth);
  this->AddLeaves(codes);
  for (int above = depth - 1; above >= 0; --above)
  {
    this->AddParents(above);
  }
}

//------------------------------------------------------------------------------
void GixelOctree::SortByCode(const std::vector<std::uint32_t>& codes, int bits)
{
  for (std::uint32_t gixel = 0; gixel < this->Size; ++gixel)
  {
    if (codes[gixel] != CellGrid::NoCell)
    {
      this->Gixels.push_back(gixel);
    }
  }
  // Least significant digit first; each pass keeps the order of equals, so gixels stay ascending.
  constexpr int widest = 12;
  const int passes = (bits + widest - 1) / widest;
  const int digit = passes ? (bits + passes - 1) / passes : 0;
  const std::uint32_t mask = (1U << digit) - 1;
  std::vector<std::uint32_t> sorted(this->Gixels.size());
  for (int pass = 0; pass < passes; ++pass)
  {
    const int shift = pass * digit;
    std::vector<std::uint32_t> first((std::size_t{ 1 } << digit) + 1);
    for (const std::uint32_t gixel : this->Gixels)
    {
      ++first[(codes[gixel] >> shift & mask) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const std::uint32_t gixel : this->Gixels)
    {
      sorted[first[codes[gixel] >> shift & mask]++] = gixel;
    }
    this->Gixels.swap(sorted);
  }
}

//------------------------------------------------------------------------------
void GixelOctree::AddLeaves(const std::vector<std::uint32_t>& codes)
{
  Level& leaves = this->Levels.back();
  for (std::size_t place = 0; place < this->Gixels.size(); ++place)
  {
    const std::uint32_t code = codes[this->Gixels[place]];
    if (leaves.Codes.empty() || leaves.Codes.back() != code)
    {
      leaves.Codes.push_back(code);
      leaves.Gixels.push_back(static_cast<std::uint32_t>(place));
    }
  }
  leaves.Gixels.push_back(static_cast<std::uint32_t>(this->Gixels.size()));
}

//------------------------------------------------------------------------------
void GixelOctree::AddParents(int depth)
{
  const Level& children = this->GetLevel(depth + 1);
  Level& parents = this->Levels[static_cast<std::size_t>(depth)];
  for (std::size_t child = 0; child < children.GetSize(); ++child)
  {
    const std::uint32_t code = children.Codes[child] >> 3;
    if (parents.Codes.empty() || parents.Codes.back() != code)
    {
      parents.Codes.push_back(code);
      parents.Gixels.push_back(children.Gixels[child]);
      parents.Children.push_back(static_cast<std::uint32_t>(child));
    }
  }
  parents.Gixels.push_back(children.Gixels.back());
  parents.Children.push_back(static_cast<std::uint32_t>(children.GetSize()));
}

//------------------------------------------------------------------------------
std::size_t GixelOctree::GetNumberOfNodes() const
{
  std::size_t nodes = 0;
  for (const Level& level : this->Levels)
  {
    nodes += level.GetSize();
  }
  return nodes;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> GixelOctree::SortGixels(int depth) const
{
  if (depth == this->GetDepth())
  {
    return this->Gixels;
  }
  const Level& level = this->GetLevel(depth);
  std::vector<std::uint32_t> nodeOf(this->Size, CellGrid::NoCell);
  for (std::uint32_t node = 0; node < level.GetSize(); ++node)
  {
    for (std::uint32_t place = level.Gixels[node]; place < level.Gixels[node + 1]; ++place)
    {
      nodeOf[this->Gixels[place]] = node;
    }
  }
  std::vector<std::uint32_t> next = level.Gixels;
  std::vector<std::uint32_t> sorted(this->Gixels.size());
  for (std::uint32_t gixel = 0; gixel < this->Size; ++gixel)
  {
    if (nodeOf[gixel] != CellGrid::NoCell)
    {
      sorted[next[nodeOf[gixel]]++] = gixel;
    }
  }
  return sorted;
}

//------------------------------------------------------------------------------
std::uint32_t GixelOctree::GetFirstLeaf(int depth, std::uint32_t node) const
{
  for (; depth < this->GetDepth(); ++depth)
  {
    node = this->GetLevel(depth).Children[node];
  }
  return node;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> GixelOctree::GetLeavesByCell() const
{
  const int depth = this->GetDepth();
  const std::vector<std::uint32_t>& codes = this->GetLeaves().Codes;
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t code : codes)
  {
    const glm::ivec3 cell = FromMorton(code);
    cells.push_back(static_cast<std::uint32_t>((cell.x << depth | cell.y) << depth | cell.z));
  }
  std::vector<std::uint32_t> leaves(codes.size());
  std::iota(leaves.begin(), leaves.end(), 0U);
  std::sort(leaves.begin(), leaves.end(),
    [&](std::uint32_t a, std::uint32_t b) { return cells[a] < cells[b]; });
  return leaves;
}

} // namespace bravais
