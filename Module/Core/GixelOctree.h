// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelOctree_h
#define GixelOctree_h

#include <cstdint>
#include <vector>

namespace bravais
{

/**
 * Octree over gixels: every non-empty cell of depths 0 .. D is a node, and those of depth D are the
 * leaves. It is built from the Morton codes of the gixels' cells by a radix sort of them, once, and
 * one pass over the nodes of a depth to make those of the depth above: no recursion, and memory of
 * a number a gixel and three a node.
 *
 * Nodes of a depth are in ascending order of their codes. Gixels are named by their place in the
 * image, row-major; an image has fewer than 2^32.
 */
class GixelOctree
{
public:
  /// The nodes of one depth. `Gixels` and `Children` have one more entry than there are nodes: node
  /// n has what is from entry n to before entry n + 1.
  struct Level
  {
    std::vector<std::uint32_t> Codes;    // of the nodes' cells
    std::vector<std::uint32_t> Gixels;   // places in GetGixels()
    std::vector<std::uint32_t> Children; // nodes of the next depth; empty for leaves

    std::size_t GetSize() const { return this->Codes.size(); }
  };

  GixelOctree() = default;

  /// From each gixel's code of 3 depth bits, or CellGrid::NoCell.
  GixelOctree(const std::vector<std::uint32_t>& codes, int depth);

  int GetDepth() const { return static_cast<int>(this->Levels.size()) - 1; }
  const Level& GetLevel(int depth) const { return this->Levels[static_cast<std::size_t>(depth)]; }
  const Level& GetLeaves() const { return this->Levels.back(); }
  std::size_t GetNumberOfNodes() const;

  /// The gixels, leaf after leaf, ascending within each.
  const std::vector<std::uint32_t>& GetGixels() const { return this->Gixels; }

  /// The gixels again, ascending within each node of a depth: O(gixels).
  std::vector<std::uint32_t> SortGixels(int depth) const;

  /// The first leaf below node `node` of a depth; that of the node after it is where they end.
  std::uint32_t GetFirstLeaf(int depth, std::uint32_t node) const;

  /// The leaves in ascending order of (x << 2D) | (y << D) | z.
  std::vector<std::uint32_t> GetLeavesByCell() const;

private:
  void SortByCode(const std::vector<std::uint32_t>& codes, int bits);
  void AddLeaves(const std::vector<std::uint32_t>& codes);
  void AddParents(int depth);

  std::vector<std::uint32_t> Gixels;
  std::vector<Level> Levels;
  std::uint32_t Size = 0; // gixels of the image, those of no cell included
};

} // namespace bravais

#endif
