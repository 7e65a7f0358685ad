// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataToGeometryImage.h"

#include "ImageChecks.h"
#include "MeshSamples.h"
#include "PieceRequest.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkPolyDataToGeometryImage);

/// The samples, and what they are of.
struct vtkPolyDataToGeometryImage::Internals
{
  std::unique_ptr<bravais::MeshSamples> Samples;
  vtkPolyData* Mesh = nullptr;
  vtkMTimeType Time = 0;
  int Dimensions[2] = { 0, 0 };
  int Rounds = 0;

  bool IsOf(vtkPolyData* mesh, const int dimensions[2], int rounds) const
  {
    return this->Samples && this->Mesh == mesh && this->Time == mesh->GetMTime() &&
      this->Dimensions[0] == dimensions[0] && this->Dimensions[1] == dimensions[1] &&
      this->Rounds == rounds;
  }
};

vtkPolyDataToGeometryImage::vtkPolyDataToGeometryImage()
  : Members(new Internals)
{
}

vtkPolyDataToGeometryImage::~vtkPolyDataToGeometryImage() = default;

//------------------------------------------------------------------------------
int vtkPolyDataToGeometryImage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPolyDataToGeometryImage::CheckDimensions(std::string& why)
{
  const int* n = this->Dimensions;
  if (n[0] < 2 || n[1] < 2)
  {
    why = "Dimensions are " + std::to_string(n[0]) + " x " + std::to_string(n[1]) +
      "; at least 2 x 2 were expected.";
    return false;
  }
  const int extent[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, 0 };
  constexpr int bytes = 64; // of a gixel: the place of its sample and its position
  return bravais::CheckMemory(extent, bytes, why);
}

//------------------------------------------------------------------------------
int vtkPolyDataToGeometryImage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  std::string why;
  if (!this->CheckDimensions(why))
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputs);
    return 0;
  }
  if (!vtkImageData::GetData(outputs))
  {
    return 1; // of many blocks, each of which is asked by itself
  }
  const int extent[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0, 0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataToGeometryImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPolyDataToGeometryImage::Parametrize(vtkPolyData* mesh, std::string& why)
{
  Internals& m = *this->Members;
  m.Samples.reset();
  auto samples = std::make_unique<bravais::MeshSamples>();
  const auto report = [&](double part)
  {
    this->UpdateProgress(part);
    return !this->GetAbortExecute();
  };
  if (!samples->SetMesh(mesh, why) || !samples->Sample(this->Dimensions, this->Rounds, report, why))
  {
    return false;
  }
  this->Stretch = samples->GetStretch();
  this->NumberOfFlippedTriangles = samples->GetNumberOfFlippedTriangles();
  m = { std::move(samples), mesh, mesh->GetMTime(), { this->Dimensions[0], this->Dimensions[1] },
    this->Rounds };
  return true;
}

//------------------------------------------------------------------------------
int vtkPolyDataToGeometryImage::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(info);
  std::string why;
  if (!mesh)
  {
    vtkErrorMacro(<< "There is no input mesh; a vtkPolyData was expected.");
    output->Initialize();
    return 0;
  }
  if (!this->Members->IsOf(mesh, this->Dimensions, this->Rounds) && !this->Parametrize(mesh, why))
  {
    output->Initialize();
    if (!why.empty())
    {
      vtkErrorMacro(<< why);
      return 0;
    }
    return 1; // aborted
  }
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  output->SetExtent(extent);
  if (output->GetNumberOfPoints() > 0)
  {
    this->Members->Samples->Fill(output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataToGeometryImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: (" << this->Dimensions[0] << ", " << this->Dimensions[1] << ")\n";
  os << indent << "Rounds: " << this->Rounds << "\n";
  os << indent << "Stretch: " << this->Stretch << "\n";
  os << indent << "NumberOfFlippedTriangles: " << this->NumberOfFlippedTriangles << "\n";
}
