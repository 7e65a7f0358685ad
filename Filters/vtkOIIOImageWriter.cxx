// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOIIOImageWriter.h"

#include "OIIOChannels.h"
#include "OIIOImageSink.h"
#include "OIIOMetadata.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/half.h>

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

vtkStandardNewMacro(vtkOIIOImageWriter);

namespace
{

/// Whether the field data of an image say that its file had halves, and it has nothing else.
bool HoldsHalves(vtkImageData* image, vtkDataArray* scalars)
{
  auto* type =
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("FileScalarType"));
  auto* floats = vtkFloatArray::SafeDownCast(scalars);
  if (!type || type->GetNumberOfValues() != 1 || type->GetValue(0) != "half" || !floats)
  {
    return false;
  }
  const float* values = floats->GetPointer(0);
  return std::all_of(values, values + floats->GetNumberOfValues(),
    [](float value) { return std::isnan(value) || static_cast<float>(half(value)) == value; });
}

/// Whether an image has point scalars for an extent, one for each point.
bool CheckScalars(vtkImageData* image, const int extent[6], std::string& why)
{
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  int held[6] = { 0, -1, 0, -1, 0, -1 };
  if (image)
  {
    image->GetExtent(held);
  }
  bool holds = scalars && scalars->HasStandardMemoryLayout() &&
    scalars->GetNumberOfTuples() == image->GetNumberOfPoints();
  for (int axis = 0; axis < 3; ++axis)
  {
    holds = holds && extent[2 * axis] <= extent[2 * axis + 1] &&
      held[2 * axis] <= extent[2 * axis] && held[2 * axis + 1] >= extent[2 * axis + 1];
  }
  if (!holds)
  {
    why = "The input is an image of " + std::to_string(image ? image->GetNumberOfPoints() : 0) +
      " points with " + std::to_string(scalars ? scalars->GetNumberOfTuples() : 0) +
      " point scalars; an image with a scalar for each point was expected.";
    return false;
  }
  return true;
}

/// The header of a slice, but for its compression and tiles. None where its type is no number.
bool MakeHeader(
  vtkImageData* image, const int extent[6], int scalarType, OIIO::ImageSpec& spec, std::string& why)
{
  if (!CheckScalars(image, extent, why))
  {
    return false;
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const bool asHalf = scalarType == vtkOIIOImageWriter::Half ||
    (scalarType == vtkOIIOImageWriter::Automatic && HoldsHalves(image, scalars));
  const OIIO::TypeDesc type =
    asHalf ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : bravais::FromVTKType(scalars->GetDataType());
  if (type == OIIO::TypeDesc::UNKNOWN || scalars->GetNumberOfComponents() < 1)
  {
    why = "The scalars are " + std::to_string(scalars->GetNumberOfComponents()) +
      " components of type " + scalars->GetDataTypeAsString() +
      "; numbers of 8 to 64 bits were expected.";
    return false;
  }
  spec = OIIO::ImageSpec(
    extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, scalars->GetNumberOfComponents(), type);
  spec.channelnames = bravais::NameOIIOChannels(spec.nchannels);
  spec.alpha_channel = spec.nchannels == 2 || spec.nchannels == 4 ? spec.nchannels - 1 : -1;
  bravais::SetOIIOMetadata(image->GetFieldData(), spec);
  spec.attribute("oiio:UnassociatedAlpha", 1); // opacity is not to change colours
  return true;
}

} // namespace

//------------------------------------------------------------------------------
const char* vtkOIIOImageWriter::GetScalarTypeAsString()
{
  constexpr const char* names[] = { "Automatic", "Input", "Half" };
  return names[this->ScalarType];
}

//------------------------------------------------------------------------------
void vtkOIIOImageWriter::Fail(unsigned long code, const std::string& why)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< why);
}

//------------------------------------------------------------------------------
std::string vtkOIIOImageWriter::GetSliceName(int slice) const
{
  if (this->FileName)
  {
    return this->FileName;
  }
  const auto print = [&](char* to, std::size_t size)
  { return std::snprintf(to, size, this->FilePattern, this->FilePrefix, slice); };
  const int length = std::max(0, print(nullptr, 0));
  std::vector<char> name(static_cast<std::size_t>(length) + 1, '\0');
  print(name.data(), name.size());
  return name.data();
}

//------------------------------------------------------------------------------
void vtkOIIOImageWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    this->Fail(vtkErrorCode::UnknownError, "There is no input; an image was expected.");
    return;
  }
  const bool series = !this->FileName || !*this->FileName;
  if (series && (!this->FilePrefix || !this->FilePattern))
  {
    this->Fail(vtkErrorCode::NoFileNameError,
      "FileName is not set; the name of a file, or a "
      "FilePrefix and FilePattern, was expected.");
    return;
  }
  vtkAlgorithm* source = this->GetInputAlgorithm();
  source->UpdateInformation();
  const int* whole =
    vtkStreamingDemandDrivenPipeline::GetWholeExtent(this->GetInputInformation(0, 0));
  const int first = whole[4];
  const int last = whole[5];
  if (!series && last > first)
  {
    this->Fail(vtkErrorCode::NoFileNameError,
      "The input has " + std::to_string(last - first + 1) +
        " slices; one was expected for a FileName. Set FilePrefix and FilePattern for a series.");
    return;
  }
  if (whole[0] > whole[1] || whole[2] > whole[3] || first > last)
  {
    this->Fail(vtkErrorCode::UnknownError,
      "The input is an image of 0 points; at least one point was expected.");
    return;
  }
  std::vector<std::string> names;
  this->UpdateProgress(0.0);
  for (int slice = first; slice <= last; ++slice)
  {
    int extent[6];
    std::copy_n(whole, 4, extent);
    extent[4] = extent[5] = slice;
    source->UpdateExtent(extent);
    std::string why;
    names.push_back(this->GetSliceName(slice));
    if (!this->WriteSlice(this->GetInput(), extent, names.back(), why))
    {
      names.pop_back(); // a file that is not complete is not there
      for (const std::string& name : names)
      {
        std::string error;
        OIIO::Filesystem::remove(name, error);
      }
      if (!this->GetAbortExecute())
      {
        this->Fail(vtkErrorCode::CannotOpenFileError, why);
      }
      return;
    }
    this->UpdateProgress((vtkIdType{ slice } - first + 1) / (vtkIdType{ last } - first + 1.0));
  }
}

//------------------------------------------------------------------------------
bool vtkOIIOImageWriter::WriteSlice(
  vtkImageData* image, const int extent[6], const std::string& name, std::string& why)
{
  OIIO::ImageSpec spec;
  bravais::OIIOImageSink sink;
  const int* tile = this->TileSize;
  if (tile[0] < 0 || tile[1] < 0 || (tile[0] == 0) != (tile[1] == 0))
  {
    why = "TileSize is " + std::to_string(tile[0]) + ", " + std::to_string(tile[1]) +
      "; two numbers above 0, or 0, 0, were expected.";
    return false;
  }
  if (!MakeHeader(image, extent, this->ScalarType, spec, why))
  {
    return false;
  }
  spec.tile_width = tile[0];
  spec.tile_height = tile[1];
  spec.tile_depth = tile[0] > 0 ? 1 : 0;
  if (!this->Compression.empty())
  {
    spec.attribute("compression", this->Compression);
  }
  bool opened = sink.Open(name, spec, why);
  if (!opened && this->ScalarType == Automatic && spec.format == OIIO::TypeDesc::HALF)
  {
    spec.format = OIIO::TypeDesc::FLOAT; // for a format without half
    opened = sink.Open(name, spec, why);
  }
  if (!opened)
  {
    return false;
  }
  // Blocks of rows, upside down: rows that formats compress together, or a row of tiles.
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const OIIO::TypeDesc type = bravais::FromVTKType(scalars->GetDataType());
  const std::size_t pixelBytes = type.size() * spec.nchannels;
  const std::size_t rowBytes = pixelBytes * spec.width;
  const int step = spec.tile_height > 0 ? spec.tile_height : 256;
  std::vector<char> block(rowBytes * std::min(step, spec.height));
  for (int row = 0; row < spec.height; row += std::min(step, spec.height - row))
  {
    const int end = row + std::min(step, spec.height - row);
    for (int y = row; y < end; ++y)
    {
      int ijk[3] = { extent[0], extent[3] - y, extent[4] };
      const auto* from = static_cast<const char*>(
        scalars->GetVoidPointer(image->ComputePointId(ijk) * spec.nchannels));
      std::copy_n(from, rowBytes, block.data() + (y - row) * rowBytes);
    }
    OIIO::ImageOutput& output = sink.GetOutput();
    const bool written = spec.tile_height > 0
      ? output.write_tiles(0, spec.width, row, end, 0, 1, type, block.data())
      : output.write_scanlines(row, end, 0, type, block.data());
    if (!written)
    {
      why = sink.Explain("cannot be written");
      return false;
    }
    if (this->GetAbortExecute())
    {
      return false;
    }
  }
  return sink.Close(why);
}

//------------------------------------------------------------------------------
void vtkOIIOImageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScalarType: " << this->GetScalarTypeAsString() << "\n";
  os << indent << "Compression: '" << this->Compression << "'\n";
  os << indent << "TileSize: (" << this->TileSize[0] << ", " << this->TileSize[1] << ")\n";
}
