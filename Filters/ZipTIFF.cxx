// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ZipTIFF.h"

#include "vtkSMPTools.h"
#include "vtkType.h"
#include "vtk_zlib.h"

#include "vtksys/FStream.hxx"

#include <algorithm>
#include <atomic>
#include <map>

namespace bravais
{

namespace
{

constexpr std::size_t ChunkSize = 1 << 16;

/// The numbers of one directory of a TIFF file, by their tags.
class Directory
{
public:
  using Numbers = std::vector<std::uint64_t>;

  Directory(const std::string& name, int image)
    : File(name.c_str(), std::ios::in | std::ios::binary)
  {
    this->Swapped = this->Get(1) == 'M';
    this->Get(1);
    const bool large = this->Get(2) == 43;
    this->Wide = large ? 8 : 4;
    this->File.seekg(large ? 8 : 4);
    std::uint64_t place = this->Get(this->Wide);
    for (int index = 0; place != 0 && this->File; ++index)
    {
      this->File.seekg(static_cast<std::streamoff>(place));
      const std::uint64_t count = this->Get(large ? 8 : 2);
      const std::uint64_t first = place + (large ? 8 : 2);
      const std::uint64_t size = large ? 20 : 12;
      if (index == image && count < 4096)
      {
        for (std::uint64_t entry = 0; entry < count; ++entry)
        {
          this->ReadEntry(first + entry * size);
        }
        return;
      }
      this->File.seekg(static_cast<std::streamoff>(first + count * size));
      place = index < image ? this->Get(this->Wide) : 0;
    }
  }

  /// The first number of a tag, or what stands for none.
  std::uint64_t GetFirst(int tag, std::uint64_t fallback) const
  {
    const auto found = this->Tags.find(tag);
    return found == this->Tags.end() || found->second.empty() ? fallback : found->second[0];
  }

  const Numbers& GetAll(int tag) { return this->Tags[tag]; }

private:
  std::uint64_t Get(int bytes)
  {
    std::uint64_t value = 0;
    for (int n = 0; n < bytes; ++n)
    {
      const auto byte = static_cast<std::uint64_t>(this->File.get() & 0xff);
      value = this->Swapped ? value << 8 | byte : value | byte << (8 * n);
    }
    return value;
  }

  void ReadEntry(std::uint64_t place)
  {
    this->File.seekg(static_cast<std::streamoff>(place));
    const int tag = static_cast<int>(this->Get(2));
    const std::uint64_t type = this->Get(2);
    const std::uint64_t count = this->Get(this->Wide);
    const int bytes = type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
    if (bytes == 0 || count > (std::uint64_t{ 1 } << 28))
    {
      return; // is no whole number
    }
    if (count * bytes > static_cast<std::uint64_t>(this->Wide))
    {
      this->File.seekg(static_cast<std::streamoff>(this->Get(this->Wide)));
    }
    Numbers& numbers = this->Tags[tag];
    for (std::uint64_t n = 0; n < count && this->File; ++n)
    {
      numbers.push_back(this->Get(bytes));
    }
    this->File.clear();
  }

  vtksys::ifstream File;
  bool Swapped = false;
  int Wide = 4; ///< bytes of an offset
  std::map<int, Numbers> Tags;
};

/// Whether so many bytes of a file are what zlib wrote, up to their check sum.
bool CheckDeflate(vtksys::ifstream& file, std::uint64_t offset, std::uint64_t size)
{
  std::vector<char> in(ChunkSize);
  std::vector<char> out(ChunkSize);
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK)
  {
    return true; // cannot be told
  }
  int state = Z_OK;
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  while (state == Z_OK && size > 0)
  {
    file.read(in.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(size, ChunkSize)));
    const auto held = static_cast<std::uint64_t>(file.gcount());
    size = held > 0 ? size - held : 0;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(held);
    do
    {
      stream.next_out = reinterpret_cast<Bytef*>(out.data());
      stream.avail_out = static_cast<uInt>(out.size());
      state = inflate(&stream, Z_NO_FLUSH);
    } while (state == Z_OK && stream.avail_out == 0);
    state = state == Z_BUF_ERROR ? Z_OK : state; // more input is needed
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END;
}

} // namespace

//------------------------------------------------------------------------------
ZipTIFF::ZipTIFF(const std::string& name, int image)
  : Name(name)
{
  Directory tags(name, image);
  const std::uint64_t compression = tags.GetFirst(259, 1);
  const std::uint64_t width = tags.GetFirst(256, 0);
  const std::uint64_t height = tags.GetFirst(257, 0);
  const bool plain = tags.GetFirst(266, 1) == 1 && tags.GetFirst(32997, 1) == 1;
  if ((compression != 8 && compression != 32946) || width == 0 || height == 0 || !plain)
  {
    return; // `plain` is of bits in order, and of one layer
  }
  const bool tiled = tags.GetFirst(322, 0) > 0;
  this->Width = tiled ? tags.GetFirst(322, 0) : width;
  this->Height = tiled ? tags.GetFirst(323, 0) : std::min(tags.GetFirst(278, height), height);
  const Directory::Numbers& offsets = tags.GetAll(tiled ? 324 : 273);
  const Directory::Numbers& sizes = tags.GetAll(tiled ? 325 : 279);
  if (this->Height == 0 || offsets.size() != sizes.size())
  {
    return;
  }
  this->Columns = (width - 1) / this->Width + 1;
  this->PerPlane = this->Columns * ((height - 1) / this->Height + 1);
  for (std::size_t n = 0; n < offsets.size(); ++n)
  {
    this->Blocks.push_back({ offsets[n], sizes[n] });
  }
}

//------------------------------------------------------------------------------
bool ZipTIFF::Check(const int columns[2], const int rows[2]) const
{
  if (this->Blocks.empty())
  {
    return true;
  }
  std::vector<Block> blocks;
  const std::uint64_t planes = this->Blocks.size() / this->PerPlane;
  for (std::uint64_t plane = 0; plane < planes; ++plane)
  {
    for (std::uint64_t y = rows[0] / this->Height; y <= (rows[1] - 1) / this->Height; ++y)
    {
      for (std::uint64_t x = columns[0] / this->Width; x <= (columns[1] - 1) / this->Width; ++x)
      {
        const std::uint64_t place = plane * this->PerPlane + y * this->Columns + x;
        if (place < this->Blocks.size() && this->Blocks[place].Size > 0)
        {
          blocks.push_back(this->Blocks[place]);
        }
      }
    }
  }
  return this->CheckBlocks(blocks);
}

//------------------------------------------------------------------------------
bool ZipTIFF::CheckBlocks(const std::vector<Block>& blocks) const
{
  std::atomic<bool> whole(true);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtksys::ifstream file(this->Name.c_str(), std::ios::in | std::ios::binary);
      for (vtkIdType n = begin; n < end && whole; ++n)
      {
        const Block& block = blocks[static_cast<std::size_t>(n)];
        if (!CheckDeflate(file, block.Offset, block.Size))
        {
          whole = false;
        }
      }
    });
  return whole;
}

//------------------------------------------------------------------------------
bool IsWholeGzip(const std::string& name, std::uint64_t bytes)
{
  gzFile file = gzopen(name.c_str(), "rb");
  if (!file)
  {
    return false;
  }
  std::vector<char> chunk(ChunkSize);
  std::uint64_t total = 0;
  int held = 0;
  while ((held = gzread(file, chunk.data(), static_cast<unsigned int>(chunk.size()))) > 0)
  {
    total += static_cast<std::uint64_t>(held);
  }
  const bool ended = gzclose(file) == Z_OK; // Z_BUF_ERROR where it ends too early
  return held == 0 && ended && total >= bytes;
}

} // namespace bravais
