// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OIIOImageSink.h"

#include "OIIOChannels.h"

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bravais
{

namespace
{

/// The method of "method:quality".
std::string GetMethod(const std::string& compression)
{
  return compression.substr(0, compression.find(':'));
}

/// Soft ramps from 0.1 to 0.9, which formats that lose something keep.
std::vector<float> MakePicture(const OIIO::ImageSpec& spec)
{
  std::vector<float> values;
  for (int y = 0; y < spec.height; ++y)
  {
    for (int x = 0; x < spec.width; ++x)
    {
      for (int channel = 0; channel < spec.nchannels; ++channel)
      {
        values.push_back(0.1F + static_cast<float>(x + y + 4 * (channel % 4)) / 180.0F);
      }
    }
  }
  return values;
}

/// The one method of a format that does not tell which was used.
const char* GetOwnMethod(const std::string& format)
{
  return format == "png" ? "zip" : format == "jpeg" ? "jpeg" : format == "webp" ? "webp" : "";
}

} // namespace

//------------------------------------------------------------------------------
OIIOImageSink::~OIIOImageSink()
{
  if (!this->PartName.empty())
  {
    if (this->Output)
    {
      this->Output->close();
      static_cast<void>(this->Output->geterror());
    }
    std::string error;
    OIIO::Filesystem::remove(this->PartName, error);
  }
}

//------------------------------------------------------------------------------
std::string OIIOImageSink::Explain(const std::string& what)
{
  std::string reason = this->Output ? this->Output->geterror() : OIIO::geterror();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return "The file '" + this->Name + "' " + what + ": " +
    (reason.empty() ? "no reason is given." : reason);
}

//------------------------------------------------------------------------------
bool OIIOImageSink::CheckFormat(const OIIO::ImageSpec& spec, std::string& why) const
{
  const std::string format = this->Output->format_name();
  const int channels = spec.nchannels;
  const bool alpha = channels == 2 || channels == 4;
  // OpenImageIO ends the program where it is asked for others.
  const bool dpx = format == "dpx" && channels != 3 && channels != 4;
  if ((channels > 4 && !this->Output->supports("nchannels")) ||
    (alpha && !this->Output->supports("alpha")) || dpx)
  {
    why = "The scalars have " + std::to_string(channels) +
      " components, which files of the format " + format + " have no channels for.";
    return false;
  }
  if (format == "rla" && spec.format != OIIO::TypeDesc::FLOAT)
  {
    why = std::string("The scalars are of type ") + spec.format.c_str() +
      "; OpenImageIO's run lengths of the format rla do not keep all integers, float was expected.";
    return false;
  }
  if (spec.tile_width > 0 && !this->Output->supports("tiles"))
  {
    why = "TileSize is " + std::to_string(spec.tile_width) + ", " +
      std::to_string(spec.tile_height) + "; the format " + format +
      " has no tiles, 0, 0 was expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool OIIOImageSink::CheckHeader(
  const OIIO::ImageSpec& spec, const OIIO::ImageSpec& actual, std::string& why) const
{
  const std::string format = this->Output->format_name();
  if (actual.format != spec.format || actual.nchannels != spec.nchannels ||
    actual.width != spec.width || actual.height != spec.height)
  {
    why = "The scalars are of type " + std::string(spec.format.c_str()) + " with " +
      std::to_string(spec.nchannels) + " components; a file of the format " + format +
      " would hold " + actual.format.c_str() + " with " + std::to_string(actual.nchannels) +
      ". Convert them first.";
    return false;
  }
  const std::vector<OIIOChannelArray> arrays = SortOIIOChannels(actual);
  if (arrays.size() != 1 || !std::is_sorted(arrays[0].Channels.begin(), arrays[0].Channels.end()))
  {
    why = "The scalars have " + std::to_string(spec.nchannels) +
      " components; a file of the format " + format + " would give them other meanings.";
    return false;
  }
  const std::string wanted = GetMethod(spec.get_string_attribute("compression"));
  if (!wanted.empty() && wanted != actual.get_string_attribute("compression", GetOwnMethod(format)))
  {
    why = "Compression is '" + wanted + "'; the name of a method that the format " + format +
      " has was expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool OIIOImageSink::TryPicture(OIIO::ImageSpec spec, std::string& why)
{
  spec.width = spec.full_width = std::min(spec.width, 64);
  spec.height = spec.full_height = std::min(spec.height, 64);
  const std::vector<float> picture = MakePicture(spec);
  if (!this->Output->open(this->PartName, spec))
  {
    why = this->Explain("cannot be written");
    return false;
  }
  const bool written = this->Output->write_image(OIIO::TypeDesc::FLOAT, picture.data());
  if (!written || !this->Output->close())
  {
    why = this->Explain("cannot be written");
    this->Output->close();
    return false;
  }
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1; // as vtkOIIOImageReader asks for
  const auto input = OIIO::ImageInput::open(this->PartName, &config);
  static_cast<void>(OIIO::geterror());
  const OIIO::ImageSpec nothing(0, 0, 0, OIIO::TypeDesc::UNKNOWN);
  if (!this->CheckHeader(spec, input ? input->spec() : nothing, why))
  {
    return false;
  }
  std::vector<float> result(picture.size());
  const bool read =
    input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, result.data());
  static_cast<void>(input->geterror());
  constexpr float tolerance = 0.1F; // for formats that lose something
  const auto close = [](float a, float b) { return std::abs(a - b) < tolerance; };
  if (!read || !std::equal(picture.begin(), picture.end(), result.begin(), close))
  {
    why = "The scalars are " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
      " or more of type " + spec.format.c_str() + " with " + std::to_string(spec.nchannels) +
      " components; as a file of the format " + this->Output->format_name() +
      " OpenImageIO does not read them back as they are. Another type, format or TileSize was "
      "expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool OIIOImageSink::Open(const std::string& name, const OIIO::ImageSpec& spec, std::string& why)
{
  this->Name = name;
  this->Output = OIIO::ImageOutput::create(name);
  const std::string format = this->Output ? this->Output->format_name() : "null";
  if (format == "null" || format == "term")
  {
    why = this->Explain("is of no format that OpenImageIO writes; an extension as .exr or .png was "
                        "expected");
    return false;
  }
  if (!this->CheckFormat(spec, why))
  {
    return false;
  }
  // The same extension, since some formats are told apart by it.
  const std::string extension = OIIO::Filesystem::extension(name);
  this->PartName = name.substr(0, name.size() - extension.size()) + ".part" + extension;
  if (!this->TryPicture(spec, why))
  {
    return false;
  }
  if (!this->Output->open(this->PartName, spec))
  {
    why = this->Explain("cannot be written");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool OIIOImageSink::Close(std::string& why)
{
  std::string error;
  if (!this->Output->close())
  {
    why = this->Explain("cannot be completed");
    return false;
  }
  if (!OIIO::Filesystem::rename(this->PartName, this->Name, error))
  {
    why = "The file '" + this->Name + "' cannot be put in place: " + error + ".";
    return false;
  }
  this->PartName.clear();
  return true;
}

} // namespace bravais
