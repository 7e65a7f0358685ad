// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OIIOImageFile.h"

#include "ImageChecks.h"
#include "OIIOChannels.h"
#include "WholeJPEG.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "vtkType.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace bravais
{

namespace
{

constexpr int MebiByte = 1 << 20;

/// Bytes of pixels that a byte of a file can stand for at most, or 0 where that is not known. What
/// Deflate can do is 1032; run lengths in bytes stop at 128, and JPEG has two bits a block or more.
/// Files of one bit a pixel are read as bytes.
double GetMostExpansion(const std::string& format, const std::string& compression)
{
  struct Limit
  {
    const char* Format;
    const char* Compression; ///< its start; empty for any
    double Expansion;
  };
  constexpr Limit limits[] = { { "bmp", "", 256 }, { "dpx", "", 16 }, { "fits", "", 16 },
    { "hdr", "", 256 }, { "jpeg", "", 2048 }, { "openexr", "none", 2 }, { "openexr", "dwa", 65536 },
    { "openexr", "", 1100 }, { "png", "", 8800 }, { "pnm", "", 16 }, { "sgi", "", 256 },
    { "targa", "", 256 }, { "tiff", "none", 16 }, { "tiff", "packbits", 1100 },
    { "tiff", "zip", 8800 }, { "tiff", "", 65536 } };
  for (const Limit& limit : limits)
  {
    if (format == limit.Format && compression.rfind(limit.Compression, 0) == 0)
    {
      return limit.Expansion;
    }
  }
  return 0.0;
}

/// OpenImageIO's explanation as the end of a sentence.
std::string Explain(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
  {
    text.pop_back();
  }
  return text.empty() ? "no reason is given" : text;
}

} // namespace

//------------------------------------------------------------------------------
bool OIIOImageFile::Fail(Trouble trouble, const std::string& text, std::string& why)
{
  this->Failure = trouble;
  why = "The file '" + this->Name + "' " + text;
  return false;
}

//------------------------------------------------------------------------------
bool OIIOImageFile::Open(const std::string& name, int subImage, int mipLevel, std::string& why)
{
  this->Name = name;
  this->SubImage = subImage;
  this->MipLevel = mipLevel;
  this->Failure = Trouble::None;
  if (!OIIO::Filesystem::is_regular(name))
  {
    const bool exists = OIIO::Filesystem::exists(name);
    return this->Fail(Trouble::NotFound,
      exists ? "is a folder or a device; an image file was expected."
             : "does not exist; the name of an image file was expected.",
      why);
  }
  if (OIIO::Filesystem::file_size(name) == 0)
  {
    return this->Fail(
      Trouble::Unrecognized, "is empty, 0 bytes long; an image file was expected.", why);
  }
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1; // colours as the file has them
  this->Input = OIIO::ImageInput::open(name, &config);
  const std::string reason = Explain(OIIO::geterror());
  if (!this->Input || this->GetFormat() == "null")
  {
    return this->Fail(Trouble::Unrecognized,
      "cannot be opened: " + reason + "; a file of a format that OpenImageIO reads was expected.",
      why);
  }
  if (subImage < 0 || mipLevel < 0 || !this->Input->seek_subimage(subImage, mipLevel))
  {
    static_cast<void>(this->Input->geterror());
    return this->Fail(Trouble::Format,
      "has no SubImage " + std::to_string(subImage) + " with a MipLevel " +
        std::to_string(mipLevel) + "; numbers from 0 were expected, of images that it has.",
      why);
  }
  this->Spec = this->Input->spec();
  return this->CheckHeader(why);
}

//------------------------------------------------------------------------------
bool OIIOImageFile::CheckHeader(std::string& why)
{
  const OIIO::ImageSpec& spec = this->Spec;
  std::ostringstream size;
  size << spec.width << " x " << spec.height;
  if (spec.depth > 1)
  {
    size << " x " << spec.depth;
  }
  size << " pixels of " << spec.nchannels << " channels";
  const int extent[6] = { 0, spec.width - 1, 0, spec.height - 1, 0, std::max(1, spec.depth) - 1 };
  std::string text;
  if (spec.deep || spec.nchannels < 1)
  {
    return this->Fail(Trouble::Format,
      "holds " + size.str() + (spec.deep ? " with many samples each, a deep image" : "") +
        "; a flat image was expected.",
      why);
  }
  constexpr std::size_t mostBytes = std::numeric_limits<int>::max();
  const std::size_t pixelBytes = spec.pixel_bytes(true);
  if (pixelBytes > mostBytes || !CheckExtent(extent, static_cast<int>(pixelBytes), text))
  {
    return this->Fail(Trouble::Format, "tells of " + size.str() + ". " + text, why);
  }
  const double bytes = static_cast<double>(spec.image_bytes(true));
  const double fileBytes = static_cast<double>(OIIO::Filesystem::file_size(this->Name));
  const double expansion =
    GetMostExpansion(this->GetFormat(), spec.get_string_attribute("compression"));
  if (expansion > 0.0 && bytes > expansion * fileBytes + MebiByte)
  {
    std::ostringstream message;
    message << "tells of " << size.str() << ", " << bytes << " bytes, but is itself " << fileBytes
            << " bytes long; " << this->GetFormat() << " of that length has " << expansion
            << " times as many at most.";
    return this->Fail(Trouble::Format, message.str(), why);
  }
  for (int channel = 0; channel < spec.nchannels; ++channel)
  {
    if (ToVTKType(spec.channelformat(channel)) == VTK_VOID)
    {
      return this->Fail(Trouble::Format,
        "has a channel of type " + std::string(spec.channelformat(channel).c_str()) +
          "; numbers of 8 to 64 bits were expected.",
        why);
    }
  }
  if (this->IsWideTIFF() && (spec.tile_width > 0 || spec.height == 1))
  {
    return this->Fail(Trouble::Format,
      "holds " + size.str() +
        " of 64 bits in tiles or in one row, of which OpenImageIO makes zeros; " +
        "rows of them, two or more, were expected.",
      why);
  }
  if (this->GetFormat() == "jpeg" && !IsWholeJPEG(this->Name))
  {
    return this->Fail(Trouble::Format,
      "tells of " + size.str() + " but is truncated: a JPEG image was expected to the end.", why);
  }
  this->Arrays = SortOIIOChannels(spec);
  return true;
}

//------------------------------------------------------------------------------
bool OIIOImageFile::IsLike(const OIIOImageFile& other) const
{
  const OIIO::ImageSpec& a = this->Spec;
  const OIIO::ImageSpec& b = other.Spec;
  const auto same = [](const OIIOChannelArray& x, const OIIOChannelArray& y)
  { return x.Name == y.Name && x.Type == y.Type && x.Channels.size() == y.Channels.size(); };
  return a.width == b.width && a.height == b.height && a.depth == b.depth &&
    std::equal(
      this->Arrays.begin(), this->Arrays.end(), other.Arrays.begin(), other.Arrays.end(), same);
}

//------------------------------------------------------------------------------
bool OIIOImageFile::HasLowerRowsFirst() const
{
  constexpr int bottomLeft = 4; // of TIFF's and Exif's orientations
  return this->Spec.get_int_attribute("Orientation", 1) == bottomLeft;
}

//------------------------------------------------------------------------------
int OIIOImageFile::CountSubImages()
{
  int count = 1;
  while (this->Input->seek_subimage(count, 0))
  {
    ++count;
  }
  static_cast<void>(this->Input->geterror());
  return count;
}

//------------------------------------------------------------------------------
int OIIOImageFile::CountMipLevels()
{
  int count = 1;
  while (this->Input->seek_subimage(this->SubImage, count))
  {
    ++count;
  }
  static_cast<void>(this->Input->geterror());
  return count;
}

//------------------------------------------------------------------------------
bool OIIOImageFile::IsWideTIFF() const
{
  return this->GetFormat() == "tiff" && this->Spec.format.size() == 8;
}

//------------------------------------------------------------------------------
int OIIOImageFile::GetRowsPerBlock() const
{
  if (this->IsWideTIFF())
  {
    return this->Spec.height; // OpenImageIO 2.4 makes zeros of single rows
  }
  if (this->Spec.tile_height > 0)
  {
    return this->Spec.tile_height;
  }
  // Formats compress up to 256 rows together.
  const OIIO::imagesize_t rows =
    8 * MebiByte / std::max<OIIO::imagesize_t>(1, this->Spec.scanline_bytes(true));
  return static_cast<int>(std::clamp<OIIO::imagesize_t>(
    rows & ~OIIO::imagesize_t{ 255 }, 16, std::max(16, this->Spec.height)));
}

//------------------------------------------------------------------------------
void OIIOImageFile::GetReadColumns(int first, int last, int& begin, int& end) const
{
  const int tile = this->Spec.tile_width;
  begin = tile > 0 ? first / tile * tile : 0;
  end = tile > 0 ? static_cast<int>(std::min<OIIO::imagesize_t>(
                     this->Spec.width, (OIIO::imagesize_t(last) / tile + 1) * tile))
                 : this->Spec.width;
}

//------------------------------------------------------------------------------
bool OIIOImageFile::ReadBlock(const int columns[2], const int rows[2], int layer,
  const int channels[2], OIIO::TypeDesc type, void* values, std::string& why)
{
  const OIIO::ImageSpec& spec = this->Spec;
  static_cast<void>(this->Input->geterror()); // of what was read before
  const bool read = spec.tile_width > 0
    ? this->Input->read_tiles(this->SubImage, this->MipLevel, spec.x + columns[0],
        spec.x + columns[1], spec.y + rows[0], spec.y + rows[1], spec.z + layer, spec.z + layer + 1,
        channels[0], channels[1], type, values)
    : this->Input->read_scanlines(this->SubImage, this->MipLevel, spec.y + rows[0],
        spec.y + rows[1], spec.z + layer, channels[0], channels[1], type, values);
  // Of strips of TIFF that cannot be read OpenImageIO 2.4 tells by its error alone.
  if (!read || this->Input->has_error())
  {
    return this->Fail(Trouble::Format,
      "is truncated or damaged, rows " + std::to_string(rows[0]) + " to " +
        std::to_string(rows[1] - 1) + " of " + std::to_string(spec.height) +
        " cannot be read: " + Explain(this->Input->geterror()) + ".",
      why);
  }
  return true;
}

} // namespace bravais
