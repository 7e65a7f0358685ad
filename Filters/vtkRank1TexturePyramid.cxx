// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TexturePyramid.h"

#include "ImageChecks.h"
#include "PieceRequest.h"
#include "Rank1Levels.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkRank1TexturePyramid);

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetKindAsString()
{
  return this->Kind == RSet ? "RSet" : "MipLevels";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetLayoutAsString()
{
  return this->Layout == Locality ? "Locality" : "Korobov";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetFilterAsString()
{
  constexpr const char* names[] = { "Box", "Bilinear", "Bicubic", "Nearest", "Automatic" };
  return names[this->Filter];
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetBoundaryModeAsString()
{
  constexpr const char* names[] = { "Periodic", "Clamp", "Mirror" };
  return names[this->BoundaryMode];
}

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* in = inputVector[0]->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  bravais::RequestExtent(in, whole);
  return 1;
}

namespace
{

bravais::Rank1ResampleParameters GetParameters(vtkRank1TexturePyramid* self)
{
  bravais::Rank1ResampleParameters parameters;
  parameters.NumberOfPoints = self->GetNumberOfPoints();
  std::copy_n(self->GetTiles(), 2, parameters.Tiles);
  std::copy_n(self->GetGenerator(), 2, parameters.Generator);
  parameters.Layout = static_cast<bravais::Rank1Layout>(self->GetLayout());
  if (self->GetFilter() != vtkRank1TexturePyramid::Automatic)
  {
    parameters.Filter = static_cast<bravais::Rank1Filter>(self->GetFilter());
  }
  parameters.Boundary = static_cast<bravais::Rank1Boundary>(self->GetBoundaryMode());
  return parameters;
}

/// The extent (n, S, T) of a level, and how many texels it has.
double GetExtent(const bravais::Rank1LevelPlan& plan, int extent[6])
{
  const vtkIdType dimensions[3] = { plan.Parameters.NumberOfPoints, plan.Parameters.Tiles[0],
    plan.Parameters.Tiles[1] };
  double texels = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = static_cast<int>(dimensions[axis]) - 1;
    texels *= static_cast<double>(dimensions[axis]);
  }
  return texels;
}

} // namespace

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  output->Initialize();
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  if (!input)
  {
    return fail("There is no input image; a picture was expected.");
  }
  if (this->NumberOfLevels < 0)
  {
    return fail("NumberOfLevels is " + std::to_string(this->NumberOfLevels) +
      "; a positive number, or 0 for all levels, was expected.");
  }
  std::string why;
  double* direction = input->GetDirectionMatrix()->GetData();
  const auto picture = bravais::Rank1Picture::Create(
    input->GetExtent(), input->GetOrigin(), input->GetSpacing(), direction, why);
  if (!picture || !bravais::CheckRank1Input(input, why))
  {
    return fail(why);
  }
  vtkDataArray* pixels = input->GetPointData()->GetScalars();
  const int bytes = pixels->GetNumberOfComponents() * pixels->GetDataTypeSize();
  const bravais::Rank1ResampleParameters parameters = GetParameters(this);
  int dimensions[3];
  if (!bravais::FindRank1Dimensions(*picture, parameters, dimensions, why))
  {
    return fail(why);
  }
  const int whole[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1 };
  const int copies = this->Kind == RSet ? 4 : 2; // 4/3, rounded up
  if (!bravais::CheckMemory(whole, copies * bytes, why))
  {
    return fail(why);
  }
  const auto plans = this->Kind == RSet
    ? bravais::PlanRank1RSet(*picture, parameters, why)
    : bravais::PlanRank1MipLevels(*picture, parameters, this->NumberOfLevels, why);
  if (!plans)
  {
    return fail(why);
  }

  const double local[3] = { 0.0, 0.0, picture->Z };
  double origin[3];
  vtkMatrix3x3::MultiplyPoint(direction, local, origin);
  double total = 0.0;
  int extent[6];
  for (const bravais::Rank1LevelPlan& plan : *plans)
  {
    total += GetExtent(plan, extent);
  }
  double begin = 0.0;
  for (unsigned int block = 0; block < plans->size(); ++block)
  {
    const bravais::Rank1LevelPlan& plan = (*plans)[block];
    const double end = begin + GetExtent(plan, extent) / total;
    vtkNew<vtkImageData> image;
    image->SetOrigin(origin);
    image->SetDirectionMatrix(direction);
    output->SetBlock(block, image);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), plan.Name.c_str());
    if (!bravais::ResampleToRank1(
          this, *picture, plan.Parameters, plan.Lattice, pixels, extent, image, begin, end))
    {
      output->Initialize();
      return 1;
    }
    begin = end;
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1TexturePyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Tiles: (" << this->Tiles[0] << ", " << this->Tiles[1] << ")\n";
  os << indent << "Generator: (" << this->Generator[0] << ", " << this->Generator[1] << ")\n";
  os << indent << "Layout: " << this->GetLayoutAsString() << "\n";
  os << indent << "Filter: " << this->GetFilterAsString() << "\n";
  os << indent << "BoundaryMode: " << this->GetBoundaryModeAsString() << "\n";
}
