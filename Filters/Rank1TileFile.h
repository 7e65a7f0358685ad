// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1TileFile_h
#define Rank1TileFile_h

/// \file
/// An r-set in a file, one tile of the lattice a tile of the file, so that a cache of tiles can
/// hold what is in use of it.
///
/// The file is one tiled image, of any format that has tiles, with member (i, j) of
/// Rank1TextureLevels.h at tile column S_0 + ... + S_(i-1) and row T_0 + ... + T_(j-1): all members
/// side by side as in a rip-map, rows of tiles in the order of v from the file's first. Texel k of
/// a tile is its pixel k in row order; the last ones, that no texel is, are 0. The description of
/// the image says which r-set it is.

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace bravais
{

/// What the description says, and where things are.
struct Rank1TileLayout
{
  std::array<std::int64_t, 3> Generator = { 1, 0, 0 }; ///< n, g1, g2
  int Tiles[2] = { 1, 1 };                             ///< of the base
  double Domain[4] = { 0.0, 1.0, 0.0, 1.0 };

  int TileSize[2] = { 16, 16 }; ///< of the file, in pixels
  std::vector<int> Columns;     ///< tiles along u of each column of members
  std::vector<int> Rows;        ///< tiles along v of each row of members

  /// The layout of an r-set; the file's tiles are multiples of 16 pixels, as TIFF wants them.
  static Rank1TileLayout Create(
    const std::array<std::int64_t, 3>& generator, const int tiles[2], const double domain[4]);

  /// That of a header. None where it describes no r-set, or one of another size.
  static std::optional<Rank1TileLayout> Read(const OIIO::ImageSpec& spec);

  std::string Describe() const;

  /// First tile of a column or row of members in the file.
  int GetFirst(const std::vector<int>& counts, int index) const;
  int GetTotal(const std::vector<int>& counts) const
  {
    return this->GetFirst(counts, static_cast<int>(counts.size()));
  }

  int GetPixels() const { return this->TileSize[0] * this->TileSize[1]; }
};

/// An open file and the cache of its tiles.
class Rank1TileFile
{
public:
  Rank1TileFile() = default;
  Rank1TileFile(const Rank1TileFile&) = delete;
  void operator=(const Rank1TileFile&) = delete;
  ~Rank1TileFile();

  bool Open(const std::string& name, int megabytes, std::string& why);

  const Rank1TileLayout& GetLayout() const { return this->Layout; }
  int GetNumberOfComponents() const { return this->Components; }
  OIIO::TypeDesc GetType() const { return this->Type; }

  std::int64_t GetHits() const;
  std::int64_t GetMisses() const;
  std::int64_t GetMemory() const;
  std::int64_t GetPeakMemory() const;
  void ResetStatistics();

  /// Whether a tile could not be read since this was asked last, and why.
  bool TakeFailure(std::string& why);

  /// Finds texels for one thread, and keeps the tiles that it found last.
  class Reader
  {
  public:
    explicit Reader(const Rank1TileFile& file);
    ~Reader();
    Reader(const Reader&) = delete;
    void operator=(const Reader&) = delete;

    /// A texel of a member, with its components together, or nullptr where its tile cannot be read.
    const void* Find(int level, std::int64_t texel);

  private:
    struct Held
    {
      std::int64_t Key = -1;
      OIIO::ImageCache::Tile* Tile = nullptr;
      const char* Pixels = nullptr;
    };

    const Rank1TileFile& File;
    OIIO::ImageCache::Perthread* Thread;
    std::array<Held, 16> Kept;
  };

private:
  std::int64_t CountTiles() const;

  std::string Name;
  Rank1TileLayout Layout;
  int Components = 0;
  OIIO::TypeDesc Type;
  OIIO::ImageCache* Cache = nullptr;
  OIIO::ImageCache::ImageHandle* Handle = nullptr;
  mutable std::mutex Mutex;
  mutable std::atomic<std::int64_t> LookUps{ 0 };
  std::int64_t CountedBefore = 0; ///< tiles read until the statistics were reset
  mutable std::atomic<bool> Failed{ false };
};

} // namespace bravais

#endif
