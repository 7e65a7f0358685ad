// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaskStore_h
#define MaskStore_h

#include "GixelOctree.h"

#include <cstdint>
#include <vector>

namespace bravais
{

/**
 * The locality masks of an octree's nodes, compressed, one after another. A mask is coded from its
 * gixels alone, so that time and memory grow with them and not with the image times the nodes.
 *
 * With Roaring, a mask that the run-length code makes smaller has that: those of images of a few
 * bytes, of a few gixels at the image's very ends, and of patterns that repeat by bytes. Which it
 * is, is in the index that every mask has, along with its place.
 */
class MaskStore
{
public:
  enum class Encoding
  {
    RunLength,
    Roaring
  };

  MaskStore() = default;

  /// For an image of so many gixels; with the masks of internal nodes, or the leaves' alone.
  MaskStore(const GixelOctree& tree, std::uint64_t gixels, Encoding encoding, bool internal);

  /// Codes the masks of one depth; depths may be coded in different threads.
  void Encode(const GixelOctree& tree, int depth);

  bool HasInternalMasks() const { return this->Internal; }
  bool Has(int depth) const { return this->Internal || depth + 1 == this->GetNumberOfLevels(); }

  /// The masks' bytes in all, or the leaves' alone; and those of no compression.
  std::uint64_t GetSize(bool leavesOnly) const;
  std::uint64_t GetUncompressedSize(bool leavesOnly) const;

  /// How many masks of a Roaring store are run-length coded.
  std::uint64_t GetNumberOfExceptions() const;

  /// One mask's code.
  struct Code
  {
    const std::uint8_t* Begin;
    const std::uint8_t* End;
    Encoding Format;
  };
  Code Get(int depth, std::uint32_t node) const;

  /// Writes 1 to one byte a gixel where a mask has a bit, and nothing elsewhere.
  void Paint(int depth, std::uint32_t node, std::uint8_t* values) const;

private:
  struct Level
  {
    std::vector<std::uint8_t> Bytes;
    std::vector<std::uint64_t> Index; // a mask's end in Bytes, times 2, plus 1 for an exception
  };

  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }

  std::uint64_t Gixels = 0;
  Encoding Format = Encoding::RunLength;
  bool Internal = true;
  std::vector<Level> Levels;
};

} // namespace bravais

#endif
