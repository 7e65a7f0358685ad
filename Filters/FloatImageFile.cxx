// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FloatImageFile.h"

#include "ImageChecks.h"

#include "vtksys/SystemTools.hxx"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace bravais
{

namespace
{

/// The bytes of a file of floats compressed to no less than this part, so that a header that tells
/// of more is taken for broken. Deflate's limit is 1032 : 1.
constexpr double MostCompression = 1100.0;

} // namespace

//------------------------------------------------------------------------------
class FloatImageFile::Internals
{
public:
  std::unique_ptr<OIIO::ImageInput> File;
};

//------------------------------------------------------------------------------
FloatImageFile::FloatImageFile()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
FloatImageFile::~FloatImageFile() = default;

//------------------------------------------------------------------------------
bool FloatImageFile::Open(const std::string& path, std::string& why)
{
  this->Path = path;
  this->Internal->File = OIIO::ImageInput::open(path);
  if (!this->Internal->File)
  {
    why = "The file " + path + " cannot be read: " + OIIO::geterror() + ".";
    return false;
  }
  const OIIO::ImageSpec& spec = this->Internal->File->spec();
  const std::string told = "The file " + path + " has " + std::to_string(spec.width) + " x " +
    std::to_string(spec.height) + " x " + std::to_string(spec.depth) + " pixels of " +
    std::to_string(spec.nchannels) + " channels of type " + spec.format.c_str();
  const auto type = spec.format.basetype;
  const bool numbers =
    type == OIIO::TypeDesc::FLOAT || type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::DOUBLE;
  if (!numbers || spec.nchannels < 3 || spec.depth > 1 || spec.width < 1 || spec.height < 1)
  {
    why = told + "; one layer of at least 3 channels of type half, float or double was expected.";
    return false;
  }
  this->Double = type == OIIO::TypeDesc::DOUBLE;
  this->Size[0] = spec.width;
  this->Size[1] = spec.height;
  const int extent[6] = { 0, spec.width - 1, 0, spec.height - 1, 0, 0 };
  if (!CheckMemory(extent, spec.nchannels * (this->Double ? 8 : 4), why))
  {
    why = told + ". " + why;
    return false;
  }
  const auto bytes = static_cast<double>(vtksys::SystemTools::FileLength(path));
  if (static_cast<double>(spec.image_bytes(true)) > MostCompression * (bytes + 1024.0))
  {
    why = told + " and " + std::to_string(static_cast<std::int64_t>(bytes)) +
      " bytes, too few for them: it is truncated, or its header is broken.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FloatImageFile::ReadRows(int first, int last, void* points, std::string& why)
{
  OIIO::ImageInput& file = *this->Internal->File;
  const OIIO::ImageSpec spec = file.spec();
  const OIIO::TypeDesc type = this->Double ? OIIO::TypeDesc::DOUBLE : OIIO::TypeDesc::FLOAT;
  const std::size_t value = type.size();
  const std::size_t row = 3 * value * static_cast<std::size_t>(spec.width);
  std::vector<char> whole;
  const std::size_t all = value * static_cast<std::size_t>(spec.nchannels) *
    static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  whole.resize(all);
  // Of a truncated TIFF it says that all is well, and leaves an error.
  if (!file.read_image(0, 0, 0, spec.nchannels, type, whole.data()) || file.has_error())
  {
    why = "The file " + this->Path + " cannot be read: " + file.geterror() + ".";
    return false;
  }
  const std::size_t pixel = value * static_cast<std::size_t>(spec.nchannels);
  for (int j = first; j <= last; ++j)
  {
    const char* from = whole.data() +
      static_cast<std::size_t>(spec.height - 1 - j) * pixel * static_cast<std::size_t>(spec.width);
    char* to = static_cast<char*>(points) + static_cast<std::size_t>(j - first) * row;
    for (int i = 0; i < spec.width; ++i, from += pixel, to += 3 * value)
    {
      std::memcpy(to, from, 3 * value);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool WriteFloatImage(const std::string& path, const GixelView& gixels, std::string& why)
{
  std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path);
  if (!file)
  {
    why = "The file " + path + " cannot be written: " + OIIO::geterror() + ".";
    return false;
  }
  const std::string format = file->format_name();
  if (format != "openexr" && format != "tiff") // the others round, clamp or flip
  {
    why = "The format " + format + " of " + path +
      " is not one that keeps floats as they are: .gim, .vti, .exr or .tif was expected.";
    return false;
  }
  const OIIO::ImageSpec spec(static_cast<int>(gixels.GetWidth()),
    static_cast<int>(gixels.GetHeight()), 3, OIIO::TypeDesc::FLOAT);
  bool written = file->open(path, spec);
  std::vector<float> row(static_cast<std::size_t>(3 * gixels.GetWidth()));
  for (int j = 0; j < spec.height && written; ++j)
  {
    GetRow(gixels, spec.height - 1 - j, row.data());
    written = file->write_scanline(j, 0, OIIO::TypeDesc::FLOAT, row.data());
  }
  written = written && file->close();
  if (!written)
  {
    why = "The file " + path + " cannot be written: " + file->geterror() + ".";
  }
  return written;
}

} // namespace bravais
