// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1ImageResample.h"

#include "ImageChecks.h"
#include "PieceRequest.h"
#include "Rank1Resample.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkRank1ImageResample);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The picture that the input is going to hold.
std::optional<bravais::Rank1Picture> GetPicture(
  vtkInformation* in, double direction[9], std::string& why)
{
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  in->Get(Pipeline::WHOLE_EXTENT(), whole);
  if (in->Has(vtkDataObject::SPACING()))
  {
    in->Get(vtkDataObject::SPACING(), spacing);
  }
  if (in->Has(vtkDataObject::ORIGIN()))
  {
    in->Get(vtkDataObject::ORIGIN(), origin);
  }
  vtkMatrix3x3::Identity(direction);
  if (in->Has(vtkDataObject::DIRECTION()))
  {
    in->Get(vtkDataObject::DIRECTION(), direction);
  }
  return bravais::Rank1Picture::Create(whole, origin, spacing, direction, why);
}

} // namespace

//------------------------------------------------------------------------------
const char* vtkRank1ImageResample::GetLayoutAsString()
{
  return this->Layout == Locality ? "Locality" : "Korobov";
}

//------------------------------------------------------------------------------
const char* vtkRank1ImageResample::GetFilterAsString()
{
  constexpr const char* names[] = { "Box", "Bilinear", "Bicubic", "Nearest", "Automatic" };
  return names[this->Filter];
}

//------------------------------------------------------------------------------
const char* vtkRank1ImageResample::GetBoundaryModeAsString()
{
  constexpr const char* names[] = { "Periodic", "Clamp", "Mirror" };
  return names[this->BoundaryMode];
}

namespace
{

bravais::Rank1ResampleParameters GetParameters(vtkRank1ImageResample* self)
{
  bravais::Rank1ResampleParameters parameters;
  parameters.NumberOfPoints = self->GetNumberOfPoints();
  std::copy_n(self->GetTiles(), 2, parameters.Tiles);
  std::copy_n(self->GetGenerator(), 2, parameters.Generator);
  parameters.Layout = static_cast<bravais::Rank1Layout>(self->GetLayout());
  if (self->GetFilter() != vtkRank1ImageResample::Automatic)
  {
    parameters.Filter = static_cast<bravais::Rank1Filter>(self->GetFilter());
  }
  parameters.Boundary = static_cast<bravais::Rank1Boundary>(self->GetBoundaryMode());
  return parameters;
}

} // namespace

//------------------------------------------------------------------------------
int vtkRank1ImageResample::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string why;
  const auto fail = [&]
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputVector);
    return 0;
  };
  if (!bravais::CheckRank1Parameters(GetParameters(this), why))
  {
    return fail();
  }
  if (!vtkImageData::GetData(outputVector))
  {
    // Many blocks, each of which is asked by itself and made whole.
    const auto texels = static_cast<int>(std::max<vtkIdType>(1, this->NumberOfPoints));
    const int least[6] = { 0, texels - 1, 0, this->Tiles[0] - 1, 0, this->Tiles[1] - 1 };
    return bravais::CheckMemory(least, 1, why) ? 1 : fail();
  }
  vtkInformation* out = outputVector->GetInformationObject(0);
  double direction[9];
  int dimensions[3];
  const auto picture = GetPicture(inputVector[0]->GetInformationObject(0), direction, why);
  if (!picture || !bravais::FindRank1Dimensions(*picture, GetParameters(this), dimensions, why))
  {
    return fail();
  }
  const int extent[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  const double local[3] = { 0.0, 0.0, picture->Z };
  double origin[3];
  vtkMatrix3x3::MultiplyPoint(direction, local, origin);
  out->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  out->Set(vtkDataObject::SPACING(), spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  out->Set(vtkDataObject::DIRECTION(), direction, 9);
  out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageResample::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  in->Get(Pipeline::WHOLE_EXTENT(), whole);
  bravais::RequestExtent(in, whole);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageResample::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  vtkInformation* out = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(in);
  vtkImageData* output = vtkImageData::GetData(out);
  int extent[6];
  out->Get(Pipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece without texels
  }
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  std::string why;
  double direction[9];
  const bravais::Rank1ResampleParameters parameters = GetParameters(this);
  const auto picture = GetPicture(in, direction, why);
  if (!picture || !bravais::CheckRank1Input(input, why))
  {
    return fail(why);
  }
  if (input->GetNumberOfPoints() != vtkIdType{ picture->Pixels[0] } * picture->Pixels[1])
  {
    return fail("The input does not hold the extent that it was asked for.");
  }
  vtkDataArray* pixels = input->GetPointData()->GetScalars();
  if (!bravais::CheckMemory(
        extent, pixels->GetNumberOfComponents() * pixels->GetDataTypeSize(), why))
  {
    return fail(why);
  }
  const auto lattice = bravais::FindRank1Lattice(*picture, parameters, why);
  if (!lattice)
  {
    return fail(why);
  }
  if (!bravais::ResampleToRank1(this, *picture, parameters, *lattice, pixels, extent, output))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1ImageResample::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Tiles: (" << this->Tiles[0] << ", " << this->Tiles[1] << ")\n";
  os << indent << "Generator: (" << this->Generator[0] << ", " << this->Generator[1] << ")\n";
  os << indent << "Layout: " << this->GetLayoutAsString() << "\n";
  os << indent << "Filter: " << this->GetFilterAsString() << "\n";
  os << indent << "BoundaryMode: " << this->GetBoundaryModeAsString() << "\n";
}
