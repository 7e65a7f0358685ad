// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOIIOImageReader.h"

#include "ImageChecks.h"
#include "OIIOImageFile.h"
#include "OIIOImageFiller.h"
#include "OIIOMetadata.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkOIIOImageReader);

//------------------------------------------------------------------------------
vtkOIIOImageReader::vtkOIIOImageReader()
{
  this->FileLowerLeft = 0;
}

//------------------------------------------------------------------------------
vtkOIIOImageReader::~vtkOIIOImageReader() = default;

namespace
{

void AddString(vtkFieldData* data, const char* name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->AddArray(array);
}

} // namespace

//------------------------------------------------------------------------------
int vtkOIIOImageReader::Fail(const std::string& why, vtkInformationVector* outputVector)
{
  using Trouble = bravais::OIIOImageFile::Trouble;
  switch (this->ImageFile ? this->ImageFile->GetTrouble() : Trouble::None)
  {
    case Trouble::None:
      this->SetErrorCode(vtkErrorCode::UnknownError);
      break;
    case Trouble::NotFound:
      this->SetErrorCode(vtkErrorCode::FileNotFoundError);
      break;
    case Trouble::Unrecognized:
      this->SetErrorCode(vtkErrorCode::UnrecognizedFileTypeError);
      break;
    case Trouble::Format:
      this->SetErrorCode(vtkErrorCode::FileFormatError);
      break;
  }
  this->ImageFile.reset();
  vtkErrorMacro(<< why);
  vtkImageData::GetData(outputVector)->Initialize();
  return 0;
}

//------------------------------------------------------------------------------
bool vtkOIIOImageReader::OpenSlice(int slice, std::string& why)
{
  const bool named = this->FileName || this->FilePrefix ||
    (this->FileNames && this->FileNames->GetNumberOfValues() > 0);
  if (named)
  {
    this->ComputeInternalFileName(slice);
  }
  if (!named || !this->InternalFileName)
  {
    why = "FileName is not set; the name of an image file was expected.";
    return false;
  }
  if (this->ImageFile && this->ImageFile->GetName() == this->InternalFileName)
  {
    return true;
  }
  auto file = std::make_unique<bravais::OIIOImageFile>();
  const bool opened = file->Open(this->InternalFileName, this->SubImage, this->MipLevel, why);
  if (opened && this->ImageFile && !file->IsLike(*this->ImageFile))
  {
    why = "Slice " + std::to_string(slice) + ", '" + this->InternalFileName + "', has " +
      std::to_string(file->GetSpec().width) + " x " + std::to_string(file->GetSpec().height) +
      " pixels of " + std::to_string(file->GetSpec().nchannels) +
      " channels; the size, channels and types of the first slice were expected.";
    return false;
  }
  this->ImageFile = std::move(file);
  return opened;
}

//------------------------------------------------------------------------------
int vtkOIIOImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  const bool series = !this->FileName;
  if (this->FileNames)
  {
    this->DataExtent[4] = 0;
    this->DataExtent[5] = static_cast<int>(this->FileNames->GetNumberOfValues()) - 1;
  }
  std::string why;
  this->ImageFile.reset();
  if (!this->OpenSlice(series ? this->DataExtent[4] : 0, why))
  {
    return this->Fail(why, outputVector);
  }
  const OIIO::ImageSpec& spec = this->ImageFile->GetSpec();
  if (series && spec.depth > 1)
  {
    return this->Fail("The file '" + this->ImageFile->GetName() + "' is of " +
        std::to_string(spec.depth) + " layers; a file of one layer was expected of each slice.",
      outputVector);
  }
  this->DataExtent[0] = this->DataExtent[2] = 0;
  this->DataExtent[1] = spec.width - 1;
  this->DataExtent[3] = spec.height - 1;
  if (!series)
  {
    this->DataExtent[4] = 0;
    this->DataExtent[5] = std::max(1, spec.depth) - 1;
  }
  const bravais::OIIOChannelArray& scalars = this->ImageFile->GetArrays()[0];
  this->DataScalarType = scalars.Type;
  this->NumberOfScalarComponents = static_cast<int>(scalars.Channels.size());

  // The place of the window in the whole picture, whose first pixel is at DataOrigin.
  const int below = spec.full_y + spec.full_height - spec.y - spec.height;
  const double offset[3] = { static_cast<double>(spec.x - spec.full_x),
    static_cast<double>(this->FileLowerLeft ? spec.y - spec.full_y : below), 0.0 };
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = this->DataOrigin[axis];
    for (int column = 0; column < 3; ++column)
    {
      origin[axis] +=
        this->DataDirection[3 * axis + column] * this->DataSpacing[column] * offset[column];
    }
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->DataExtent, 6);
  info->Set(vtkDataObject::SPACING(), this->DataSpacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::DIRECTION(), this->DataDirection, 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->DataScalarType, this->NumberOfScalarComponents);
  return 1;
}

//------------------------------------------------------------------------------
int vtkOIIOImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  output->Initialize();
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece without points
  }
  const bool series = !this->FileName;
  std::string why;
  if (!this->OpenSlice(series ? extent[4] : 0, why))
  {
    return this->Fail(why, outputVector);
  }
  if (!bravais::CheckMemory(
        extent, static_cast<int>(this->ImageFile->GetSpec().pixel_bytes(true)), why))
  {
    return this->Fail(
      "The file '" + this->ImageFile->GetName() + "' is too large. " + why, outputVector);
  }
  const bool flip = this->FileLowerLeft == 0 && !this->ImageFile->HasLowerRowsFirst();
  bravais::OIIOImageFiller filler(*this->ImageFile, output, extent, flip);
  const double slices = vtkIdType{ extent[5] } - extent[4] + 1;
  bool allocated = false;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    if (series && !this->OpenSlice(k, why))
    {
      return this->Fail(why, outputVector);
    }
    filler.SetFile(*this->ImageFile);
    int wanted[2];
    filler.GetRows(wanted);
    const int step = this->ImageFile->GetRowsPerBlock();
    const int height = this->ImageFile->GetSpec().height;
    for (int row = wanted[0] / step * step; row < wanted[1]; row += step)
    {
      const int rows[2] = { row, row + std::min(step, height - row) };
      this->UpdateProgress(
        (k - extent[4] + (row - wanted[0]) / static_cast<double>(wanted[1] - wanted[0])) / slices);
      if (this->GetAbortExecute())
      {
        output->Initialize();
        return 1;
      }
      if (!filler.ReadBlock(rows, series ? 0 : k, why))
      {
        return this->Fail(why, outputVector);
      }
      if (!allocated)
      {
        filler.Allocate();
        allocated = true;
      }
      filler.StoreBlock(rows, k);
      if (step > height - row)
      {
        break;
      }
    }
  }
  bravais::AddOIIOMetadata(this->ImageFile->GetSpec(), output->GetFieldData());
  if (this->ImageFile->HasLowerRowsFirst())
  {
    output->GetFieldData()->RemoveArray("Orientation"); // it is no longer so
  }
  AddString(output->GetFieldData(), "FileFormat", this->ImageFile->GetFormat());
  AddString(output->GetFieldData(), "FileScalarType",
    this->ImageFile->GetSpec().channelformat(this->ImageFile->GetArrays()[0].Channels[0]).c_str());
  this->ImageFile.reset(); // closes it
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkOIIOImageReader::CanReadFile(const char* name)
{
  std::string why;
  bravais::OIIOImageFile file;
  return name && file.Open(name, 0, 0, why) ? 2 : 0;
}

//------------------------------------------------------------------------------
const char* vtkOIIOImageReader::GetFileExtensions()
{
  // "tiff:tif,tiff,tx;openexr:exr ..."
  const std::string formats =
    "," + std::string(OIIO::get_string_attribute("input_format_list")) + ",";
  this->Extensions.clear();
  for (const auto& [format, extensions] : OIIO::get_extension_map())
  {
    if (format == "null" || formats.find("," + format + ",") == std::string::npos)
    {
      continue;
    }
    for (const std::string& extension : extensions)
    {
      this->Extensions += (this->Extensions.empty() ? "." : " .") + extension;
    }
  }
  return this->Extensions.c_str();
}

//------------------------------------------------------------------------------
int vtkOIIOImageReader::GetNumberOfSubImages()
{
  std::string why;
  bravais::OIIOImageFile file;
  this->ComputeInternalFileName(this->FileName ? 0 : this->DataExtent[4]);
  return this->InternalFileName && file.Open(this->InternalFileName, 0, 0, why)
    ? file.CountSubImages()
    : 0;
}

//------------------------------------------------------------------------------
int vtkOIIOImageReader::GetNumberOfMipLevels()
{
  std::string why;
  bravais::OIIOImageFile file;
  this->ComputeInternalFileName(this->FileName ? 0 : this->DataExtent[4]);
  return this->InternalFileName && file.Open(this->InternalFileName, this->SubImage, 0, why)
    ? file.CountMipLevels()
    : 0;
}

//------------------------------------------------------------------------------
void vtkOIIOImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SubImage: " << this->SubImage << "\n";
  os << indent << "MipLevel: " << this->MipLevel << "\n";
}
