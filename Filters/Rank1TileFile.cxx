// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1TileFile.h"

#include "OIIOImageFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace bravais
{

namespace
{

constexpr const char* Format = "rank-1 r-set 1"; ///< starts a description

std::vector<int> CountHalvings(int tiles)
{
  std::vector<int> counts;
  for (; tiles > 0; tiles /= 2)
  {
    counts.push_back(tiles);
  }
  return counts;
}

std::int64_t RoundUp(double number)
{
  return 16 * std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(number / 16.0)));
}

} // namespace

//------------------------------------------------------------------------------
Rank1TileLayout Rank1TileLayout::Create(
  const std::array<std::int64_t, 3>& generator, const int tiles[2], const double domain[4])
{
  Rank1TileLayout layout;
  layout.Generator = generator;
  std::copy_n(tiles, 2, layout.Tiles);
  std::copy_n(domain, 4, layout.Domain);
  const auto n = static_cast<double>(generator[0]);
  layout.TileSize[0] = static_cast<int>(RoundUp(std::sqrt(n)));
  layout.TileSize[1] = static_cast<int>(RoundUp(n / layout.TileSize[0]));
  layout.Columns = CountHalvings(tiles[0]);
  layout.Rows = CountHalvings(tiles[1]);
  return layout;
}

//------------------------------------------------------------------------------
int Rank1TileLayout::GetFirst(const std::vector<int>& counts, int index) const
{
  int first = 0;
  for (int i = 0; i < index; ++i)
  {
    first += counts[i];
  }
  return first;
}

//------------------------------------------------------------------------------
std::string Rank1TileLayout::Describe() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << Format << ": n g1 g2 " << this->Generator[0] << " " << this->Generator[1] << " "
       << this->Generator[2] << " tiles " << this->Tiles[0] << " " << this->Tiles[1] << " domain";
  for (const double number : this->Domain)
  {
    text << " " << number;
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::optional<Rank1TileLayout> Rank1TileLayout::Read(const OIIO::ImageSpec& spec)
{
  const std::string text = spec.get_string_attribute("ImageDescription");
  const std::string start = std::string(Format) + ": n g1 g2 ";
  if (text.rfind(start, 0) != 0)
  {
    return std::nullopt;
  }
  std::istringstream words(text.substr(start.size()));
  words.imbue(std::locale::classic());
  std::string word;
  std::array<std::int64_t, 3> generator;
  int tiles[2];
  double domain[4];
  words >> generator[0] >> generator[1] >> generator[2] >> word >> tiles[0] >> tiles[1] >> word >>
    domain[0] >> domain[1] >> domain[2] >> domain[3];
  constexpr int mostTiles = 1 << 20;
  constexpr std::int64_t mostTexels = 1 << 30;
  if (!words || generator[0] < 1 || generator[0] > mostTexels || tiles[0] < 1 || tiles[1] < 1 ||
    tiles[0] > mostTiles || tiles[1] > mostTiles)
  {
    return std::nullopt;
  }
  Rank1TileLayout layout = Rank1TileLayout::Create(generator, tiles, domain);
  const std::int64_t width = std::int64_t{ layout.TileSize[0] } * layout.GetTotal(layout.Columns);
  const std::int64_t height = std::int64_t{ layout.TileSize[1] } * layout.GetTotal(layout.Rows);
  if (spec.width != width || spec.height != height || spec.tile_width != layout.TileSize[0] ||
    spec.tile_height != layout.TileSize[1])
  {
    return std::nullopt;
  }
  return layout;
}

//------------------------------------------------------------------------------
Rank1TileFile::~Rank1TileFile()
{
  if (this->Cache)
  {
    OIIO::ImageCache::destroy(this->Cache, true);
  }
}

//------------------------------------------------------------------------------
bool Rank1TileFile::Open(const std::string& name, int megabytes, std::string& why)
{
  this->Name = name;
  OIIOImageFile file;
  if (!file.Open(name, 0, 0, why))
  {
    return false;
  }
  const OIIO::ImageSpec& spec = file.GetSpec();
  const auto layout = Rank1TileLayout::Read(spec);
  const bool typed = spec.format == OIIO::TypeDesc::UINT8 ||
    spec.format == OIIO::TypeDesc::UINT16 || spec.format == OIIO::TypeDesc::HALF ||
    spec.format == OIIO::TypeDesc::FLOAT;
  if (!layout || !typed)
  {
    why = "The file '" + name + "' of " + std::to_string(spec.width) + " x " +
      std::to_string(spec.height) +
      " pixels is no r-set; one that vtkRank1TextureFileWriter has written was expected.";
    return false;
  }
  this->Layout = *layout;
  this->Components = spec.nchannels;
  this->Type = spec.format;
  this->Cache = OIIO::ImageCache::create(false);
  this->Cache->attribute("max_memory_MB", static_cast<float>(megabytes));
  this->Cache->attribute("unassociatedalpha", 1); // texels as they are
  // What the cache keeps for a thread by itself would outlive the cache.
  OIIO::ImageCache::Perthread* thread = this->Cache->create_thread_info();
  this->Handle = this->Cache->get_image_handle(OIIO::ustring(name), thread);
  this->Cache->destroy_thread_info(thread);
  return true;
}

//------------------------------------------------------------------------------
std::int64_t Rank1TileFile::CountTiles() const
{
  int tiles = 0;
  this->Cache->getattribute("stat:tiles_created", tiles);
  return tiles;
}

//------------------------------------------------------------------------------
std::int64_t Rank1TileFile::GetMisses() const
{
  return this->CountTiles() - this->CountedBefore;
}

//------------------------------------------------------------------------------
std::int64_t Rank1TileFile::GetHits() const
{
  return std::max<std::int64_t>(0, this->LookUps - this->GetMisses());
}

//------------------------------------------------------------------------------
std::int64_t Rank1TileFile::GetMemory() const
{
  long long bytes = 0;
  this->Cache->getattribute("stat:cache_memory_used", OIIO::TypeDesc::INT64, &bytes);
  return bytes;
}

//------------------------------------------------------------------------------
std::int64_t Rank1TileFile::GetPeakMemory() const
{
  int tiles = 0;
  this->Cache->getattribute("stat:tiles_peak", tiles);
  return static_cast<std::int64_t>(tiles) * this->Layout.GetPixels() * this->Components *
    static_cast<std::int64_t>(this->Type.size());
}

//------------------------------------------------------------------------------
void Rank1TileFile::ResetStatistics()
{
  this->CountedBefore = this->CountTiles();
  this->LookUps = 0;
}

//------------------------------------------------------------------------------
bool Rank1TileFile::TakeFailure(std::string& why)
{
  if (!this->Failed.exchange(false))
  {
    return false;
  }
  std::string reason = this->Cache->geterror();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  why = "The file '" + this->Name + "' is truncated or damaged, a tile cannot be read: " +
    (reason.empty() ? "no reason is given" : reason) + ".";
  return true;
}

//------------------------------------------------------------------------------
Rank1TileFile::Reader::Reader(const Rank1TileFile& file)
  : File(file)
  , Thread(file.Cache->create_thread_info())
{
}

//------------------------------------------------------------------------------
Rank1TileFile::Reader::~Reader()
{
  for (const Held& held : this->Kept)
  {
    if (held.Tile)
    {
      this->File.Cache->release_tile(held.Tile);
    }
  }
  this->File.Cache->destroy_thread_info(this->Thread);
}

//------------------------------------------------------------------------------
const void* Rank1TileFile::Reader::Find(int level, std::int64_t texel)
{
  const Rank1TileLayout& layout = this->File.Layout;
  const auto columns = static_cast<int>(layout.Columns.size());
  const int i = level % columns;
  const int j = level / columns;
  const std::int64_t n = layout.Generator[0];
  const std::int64_t tile = texel / n;
  const std::int64_t column = layout.GetFirst(layout.Columns, i) + tile % layout.Columns[i];
  const std::int64_t row = layout.GetFirst(layout.Rows, j) + tile / layout.Columns[i];
  const std::int64_t key = column << 32 | row;
  Held& held = this->Kept[static_cast<std::size_t>(column * 5 + row) % this->Kept.size()];
  if (held.Key != key)
  {
    if (held.Tile)
    {
      this->File.Cache->release_tile(held.Tile);
    }
    // One at a time: the cache drops tiles in a thread that others do not wait for, and so may
    // grow beyond its bound.
    const std::lock_guard<std::mutex> lock(this->File.Mutex);
    ++this->File.LookUps;
    held.Key = key;
    held.Tile = this->File.Cache->get_tile(this->File.Handle, this->Thread, 0, 0,
      static_cast<int>(column * layout.TileSize[0]), static_cast<int>(row * layout.TileSize[1]), 0);
    OIIO::TypeDesc type;
    held.Pixels = held.Tile
      ? static_cast<const char*>(this->File.Cache->tile_pixels(held.Tile, type))
      : nullptr;
    if (!held.Pixels || type != this->File.Type)
    {
      held.Pixels = nullptr;
      this->File.Failed = true;
    }
  }
  return held.Pixels ? held.Pixels +
      (texel - tile * n) * this->File.Components * static_cast<std::int64_t>(this->File.Type.size())
                     : nullptr;
}

} // namespace bravais
