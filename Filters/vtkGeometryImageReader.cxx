// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageReader.h"

#include "FloatImageFile.h"
#include "GeometryImage.h"
#include "GimFile.h"
#include "ImageChecks.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>

vtkStandardNewMacro(vtkGeometryImageReader);

//------------------------------------------------------------------------------
class vtkGeometryImageReader::Internals
{
public:
  int Size[2] = { 0, 0 };
  bool Gim = false;
  vtkSmartPointer<vtkAlgorithm> Reader; // VTK's
  std::unique_ptr<bravais::FloatImageFile> Picture;
  std::string Errors; // of Reader
};

namespace
{

/// Keeps the first line of an error instead of showing it.
void KeepError(vtkObject*, unsigned long, void* client, void* text)
{
  auto& kept = *static_cast<std::string*>(client);
  if (kept.empty() && text)
  {
    const std::string whole = static_cast<const char*>(text);
    const std::size_t start = whole.find("): ");
    kept = whole.substr(start == std::string::npos ? 0 : start + 3);
    kept = kept.substr(0, kept.find('\n'));
  }
}

/// Positions of an image that is not tagged: its vectors, or else its scalars.
vtkDataArray* FindPositions(vtkImageData* image)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* named = data->GetArray(bravais::GeometryImagePoints);
  vtkDataArray* vectors = data->GetVectors();
  return named ? named : vectors ? vectors : data->GetScalars();
}

} // namespace

//------------------------------------------------------------------------------
vtkGeometryImageReader::vtkGeometryImageReader()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkGeometryImageReader::~vtkGeometryImageReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkGeometryImageReader::OpenWithVTK(const std::string& ending, std::string& why)
{
  Internals& own = *this->Internal;
  if (ending == ".vti")
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(this->FileName);
    own.Reader = reader;
  }
  else
  {
    vtkSmartPointer<vtkImageReader2> reader;
    reader.TakeReference(vtkImageReader2Factory::CreateImageReader2(this->FileName));
    if (!reader)
    {
      why = "The file " + std::string(this->FileName) + " is not what its ending, " + ending +
        ", tells.";
      return false;
    }
    reader->SetFileName(this->FileName);
    own.Reader = reader;
  }
  own.Errors.clear();
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepError);
  keep->SetClientData(&own.Errors);
  own.Reader->AddObserver(vtkCommand::ErrorEvent, keep);
  if (auto* reader = vtkXMLReader::SafeDownCast(own.Reader))
  {
    reader->SetParserErrorObserver(keep);
  }
  vtkNew<vtkCallbackCommand> ignore; // the executive says no more than that there was an error
  own.Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignore);
  own.Reader->UpdateInformation();
  vtkInformation* info = own.Reader->GetOutputInformation(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  }
  const std::string told =
    "The file " + std::string(this->FileName) + " cannot be read as a geometry image. ";
  if (!own.Errors.empty())
  {
    why = told + own.Errors;
    return false;
  }
  if (!bravais::CheckMemory(whole, 12, why))
  {
    why = told + why;
    return false;
  }
  if (whole[4] != whole[5])
  {
    why =
      told + "Its dimensions are " + bravais::JoinDimensions(whole) + "; one slice was expected.";
    return false;
  }
  own.Size[0] = whole[1] - whole[0] + 1;
  own.Size[1] = whole[3] - whole[2] + 1;
  return true;
}

//------------------------------------------------------------------------------
bool vtkGeometryImageReader::Open(std::string& why)
{
  this->Internal = std::make_unique<Internals>();
  Internals& own = *this->Internal;
  if (!this->FileName || !*this->FileName)
  {
    why = "There is no FileName; that of a .gim, .vti or float image file was expected.";
    return false;
  }
  if (!vtksys::SystemTools::FileExists(this->FileName, true))
  {
    why = "There is no file " + std::string(this->FileName) + ".";
    return false;
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(this->FileName));
  if (ending == ".gim")
  {
    own.Gim = true;
    return bravais::ReadGimHeader(this->FileName, own.Size, why);
  }
  if (ending == ".vti" || ending == ".mhd" || ending == ".mha" || ending == ".vtk")
  {
    return this->OpenWithVTK(ending, why);
  }
  own.Picture = std::make_unique<bravais::FloatImageFile>();
  if (!own.Picture->Open(this->FileName, why))
  {
    return false;
  }
  std::copy_n(own.Picture->GetSize(), 2, own.Size);
  return true;
}

//------------------------------------------------------------------------------
int vtkGeometryImageReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  std::string why;
  if (!this->Open(why))
  {
    this->Internal = std::make_unique<Internals>();
    vtkErrorMacro(<< why);
    vtkImageData::GetData(outputVector)->Initialize();
    return 0;
  }
  const int* size = this->Internal->Size;
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int whole[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkGeometryImageReader::Read(vtkImageData* output, const int extent[6], std::string& why)
{
  Internals& own = *this->Internal;
  if (own.Reader)
  {
    own.Reader->Update();
    auto* image = vtkImageData::SafeDownCast(own.Reader->GetOutputDataObject(0));
    if (!own.Errors.empty() || !image || image->GetNumberOfPoints() < 1)
    {
      why = "The file " + std::string(this->FileName) + " cannot be read. " + own.Errors;
      return false;
    }
    output->ShallowCopy(image);
    output->SetExtent(0, own.Size[0] - 1, 0, own.Size[1] - 1, 0, 0);
    vtkSmartPointer<vtkDataArray> positions = FindPositions(image);
    if (!bravais::IsGeometryImage(output) && positions)
    {
      vtkSmartPointer<vtkDataArray> points;
      points.TakeReference(positions->NewInstance());
      points->ShallowCopy(positions);
      points->SetName(bravais::GeometryImagePoints);
      output->GetPointData()->Initialize();
      output->GetPointData()->AddArray(points); // which is set as vectors if it can be
    }
    bravais::TagGeometryImage(output);
    if (!bravais::CheckGeometryImage(output, why))
    {
      why = "The file " + std::string(this->FileName) + " holds no geometry image. " + why;
      return false;
    }
    output->Crop(extent);
    return true;
  }
  const int rows[2] = { extent[2], extent[3] };
  const bool all = extent[0] == 0 && extent[1] == own.Size[0] - 1;
  output->SetExtent(0, own.Size[0] - 1, rows[0], rows[1], 0, 0);
  vtkSmartPointer<vtkDataArray> points;
  points.TakeReference(
    vtkDataArray::CreateDataArray(own.Picture && own.Picture->IsDouble() ? VTK_DOUBLE : VTK_FLOAT));
  points->SetName(bravais::GeometryImagePoints);
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(output->GetNumberOfPoints());
  void* values = points->GetVoidPointer(0);
  if (own.Gim ? !bravais::ReadGimRows(
                  this->FileName, own.Size, rows[0], rows[1], static_cast<float*>(values), why)
              : !own.Picture->ReadRows(rows[0], rows[1], values, why))
  {
    return false;
  }
  output->GetPointData()->SetVectors(points);
  bravais::TagGeometryImage(output);
  if (!all)
  {
    output->Crop(extent);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkGeometryImageReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    bravais::TagGeometryImage(output);
    return 1; // a piece without gixels
  }
  this->UpdateProgress(0.0);
  std::string why;
  if (!this->Read(output, extent, why))
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  this->UpdateProgress(1.0);
  if (this->GetAbortExecute())
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGeometryImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
