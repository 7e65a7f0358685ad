// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ZipTIFF_h
#define ZipTIFF_h

#include <cstdint>
#include <string>
#include <vector>

namespace bravais
{

/// The strips or tiles of one image of a TIFF file that Deflate has compressed, and their check
/// sums, of which OpenImageIO 2.4 and libtiff take no notice.
class ZipTIFF
{
public:
  /// Finds those of the image, counted from 0. There are none where the file is of another kind, or
  /// its image is not compressed so.
  ZipTIFF(const std::string& name, int image);

  /// Whether what holds columns and rows begin .. end - 1 is as it was written.
  bool Check(const int columns[2], const int rows[2]) const;

private:
  struct Block
  {
    std::uint64_t Offset;
    std::uint64_t Size;
  };

  bool CheckBlocks(const std::vector<Block>& blocks) const;

  std::string Name;
  std::vector<Block> Blocks;  ///< row after row, plane after plane
  std::uint64_t Width = 0;    ///< of a block
  std::uint64_t Height = 0;   ///< likewise
  std::uint64_t Columns = 0;  ///< of blocks
  std::uint64_t PerPlane = 0; ///< blocks
};

/// Whether a file that may be compressed as by gzip holds so many bytes, all as they were written.
bool IsWholeGzip(const std::string& name, std::uint64_t bytes);

} // namespace bravais

#endif
