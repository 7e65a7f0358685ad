// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageToPolyData.h"

#include "GeometryImage.h"
#include "GixelSurface.h"
#include "ImageChecks.h"
#include "PieceRequest.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <string>

vtkStandardNewMacro(vtkGeometryImageToPolyData);

//------------------------------------------------------------------------------
int vtkGeometryImageToPolyData::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeometryImageToPolyData::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (this->LevelOfDetail < 0 || this->LevelOfDetail > bravais::GixelLine::MaximumLevel)
  {
    vtkErrorMacro(<< "LevelOfDetail is " << this->LevelOfDetail << "; 0 to "
                  << bravais::GixelLine::MaximumLevel << " were expected.");
    bravais::RefuseInformation(outputs);
    return 0;
  }
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeometryImageToPolyData::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  bravais::RequestExtent(in, whole);
  return 1;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkGeometryImageToPolyData::FindMask(vtkImageData* image)
{
  return this->UseLocalityMask ? image->GetPointData()->GetArray("LocalityMask") : nullptr;
}

//------------------------------------------------------------------------------
bool vtkGeometryImageToPolyData::CheckInput(vtkImageData* image, std::string& why)
{
  if (!bravais::CheckGeometryImage(image, why) ||
    !bravais::CheckFinite(bravais::GixelView(image), why))
  {
    return false;
  }
  vtkDataArray* mask = this->FindMask(image);
  if (mask &&
    (!vtkUnsignedCharArray::SafeDownCast(mask) || mask->GetNumberOfComponents() != 1 ||
      mask->GetNumberOfTuples() != image->GetNumberOfPoints()))
  {
    why = "The array `LocalityMask` has " + std::to_string(mask->GetNumberOfTuples()) +
      " tuples of " + std::to_string(mask->GetNumberOfComponents()) + " components of type " +
      mask->GetDataTypeAsString() + "; " + std::to_string(image->GetNumberOfPoints()) +
      " tuples of 1 component of type unsigned char were expected.";
    return false;
  }
  return bravais::CheckPointArrays(image, why);
}

//------------------------------------------------------------------------------
int vtkGeometryImageToPolyData::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(info);
  std::string why;
  if (!this->CheckInput(image, why))
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  auto* mask = vtkUnsignedCharArray::SafeDownCast(this->FindMask(image));
  bravais::GixelSurface surface(this, image, this->LevelOfDetail);
  if (info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    surface.SetPiece(
      info->Get(Pipeline::UPDATE_PIECE_NUMBER()), info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  }
  surface.MakePoints(output);
  if (this->ComputeTextureCoordinates && !output->GetPointData()->GetTCoords())
  {
    surface.MakeTextureCoordinates(output);
  }
  if (!surface.MakeTriangles(
        output, mask ? mask->GetPointer(0) : nullptr, this->GenerateTriangleStrips) ||
    (this->ComputeNormals && !surface.MakeNormals(output)))
  {
    output->Initialize(); // aborted
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGeometryImageToPolyData::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto say = [](bool on) { return on ? "On\n" : "Off\n"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelOfDetail: " << this->LevelOfDetail << "\n";
  os << indent << "UseLocalityMask: " << say(this->UseLocalityMask);
  os << indent << "GenerateTriangleStrips: " << say(this->GenerateTriangleStrips);
  os << indent << "ComputeNormals: " << say(this->ComputeNormals);
  os << indent << "ComputeTextureCoordinates: " << say(this->ComputeTextureCoordinates);
}
