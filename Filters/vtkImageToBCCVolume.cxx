// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageToBCCVolume.h"

#include "BCCChecks.h"
#include "BCCPlacement.h"
#include "BCCResample.h"
#include "BCCSubset.h"
#include "ImageChecks.h"
#include "LatticeTag.h"
#include "LayerSampler.h"
#include "PieceRequest.h"
#include "vtkBCCLattice.h"

#include "vtkDataArray.h"
#include "vtkImageBSplineInterpolator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkImageToBCCVolume);

namespace
{
bool IsEmpty(const int e[6])
{
  return e[0] > e[1] || e[2] > e[3] || e[4] > e[5];
}

bool Covers(const int outer[6], const int inner[6])
{
  bool covers = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    covers =
      covers && outer[2 * axis] <= inner[2 * axis] && outer[2 * axis + 1] >= inner[2 * axis + 1];
  }
  return covers;
}

/// How far beside a point the interpolator reads, on one side alone if a border cuts the other
/// off, so that no piece is thinner than the kernel. This also tells it the output's sampling, so
/// that is told last; by itself it may find a smaller kernel, from the steps without the start.
void GetReach(
  vtkAbstractImageInterpolator* interpolator, const bravais::BCCPlacement& placement, int reach[3])
{
  double matrix[16];
  int size[3];
  placement.GetMatrix(0, matrix);
  interpolator->ComputeSupportSize(nullptr, reach);
  interpolator->ComputeSupportSize(matrix, size);
  for (int axis = 0; axis < 3; ++axis)
  {
    reach[axis] = std::max(reach[axis], size[axis]);
  }
}
}

//------------------------------------------------------------------------------
vtkImageToBCCVolume::vtkImageToBCCVolume()
{
  auto spline = vtkSmartPointer<vtkImageBSplineInterpolator>::New();
  spline->SetBorderModeToMirror();
  this->Interpolator = spline;
}

//------------------------------------------------------------------------------
vtkImageToBCCVolume::~vtkImageToBCCVolume() = default;

//------------------------------------------------------------------------------
const char* vtkImageToBCCVolume::GetModeAsString()
{
  return this->Mode == Subset ? "Subset" : "Resample";
}

//------------------------------------------------------------------------------
void vtkImageToBCCVolume::SetInterpolator(vtkAbstractImageInterpolator* interpolator)
{
  if (this->Interpolator != interpolator)
  {
    this->Interpolator = interpolator;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkAbstractImageInterpolator* vtkImageToBCCVolume::GetInterpolator()
{
  return this->Interpolator;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkImageToBCCVolume::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Interpolator ? std::max(own, this->Interpolator->GetMTime()) : own;
}

//------------------------------------------------------------------------------
bool vtkImageToBCCVolume::CheckParameters(bool blocks, std::string& why) const
{
  if (this->Mode == Subset)
  {
    return true;
  }
  if (!this->Interpolator || this->Interpolator->IsA("vtkBCCInterpolator"))
  {
    why = std::string("Interpolator is ") +
      (this->Interpolator ? this->Interpolator->GetClassName() : "none") +
      "; one for Cartesian images was expected.";
    return false;
  }
  const int* n = this->Dimensions;
  const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  // Blocks are made whole, others maybe piece by piece.
  return bravais::CheckIsotropic(n, this->SampleRatio, why) &&
    (!blocks || n[0] == 0 || bravais::CheckMemory(whole, 1, why));
}

//------------------------------------------------------------------------------
bool vtkImageToBCCVolume::Place(vtkInformation* inInfo, bravais::ImageGrid& grid,
  bravais::BCCPlacement& placement, std::string& why) const
{
  if (!bravais::ReadGrid(inInfo, grid, why))
  {
    return false;
  }
  if (this->Mode == Subset)
  {
    placement = bravais::PlaceSubset(grid);
    return true;
  }
  return bravais::PlaceIsotropic(grid, this->Dimensions, this->SampleRatio, placement, why);
}

//------------------------------------------------------------------------------
bool vtkImageToBCCVolume::NeedsWholeInput(const bravais::BCCPlacement& placement) const
{
  return this->Mode == Resample &&
    ((this->LowPass && placement.IsDecimation()) || bravais::NeedsCoefficients(this->Interpolator));
}

//------------------------------------------------------------------------------
void vtkImageToBCCVolume::GetInputExtent(const bravais::ImageGrid& grid,
  const bravais::BCCPlacement& placement, const int extent[6], int inExtent[6]) const
{
  if (this->NeedsWholeInput(placement))
  {
    std::copy_n(grid.Whole, 6, inExtent);
    return;
  }
  int reach[3] = { 0, 0, 0 };
  if (this->Mode == Resample)
  {
    GetReach(this->Interpolator, placement, reach);
  }
  placement.GetImageExtent(grid, extent, reach, inExtent);
}

//------------------------------------------------------------------------------
int vtkImageToBCCVolume::Fail(vtkInformationVector* outputVector, const std::string& why)
{
  vtkErrorMacro(<< why);
  vtkImageData::GetData(outputVector)->Initialize();
  return 0;
}

//------------------------------------------------------------------------------
int vtkImageToBCCVolume::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  bravais::ImageGrid grid;
  bravais::BCCPlacement placement;
  std::string why;
  const auto fail = [&]
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputVector);
    return 0;
  };
  const bool blocks = !vtkImageData::GetData(outputVector);
  if (!this->CheckParameters(blocks, why))
  {
    return fail();
  }
  if (blocks)
  {
    return 1; // each is asked by itself
  }
  if (!this->Place(inInfo, grid, placement, why))
  {
    return fail();
  }
  const int* n = placement.Dimensions;
  const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  int type = VTK_DOUBLE;
  int components = 1;
  if (vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
        inInfo, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS))
  {
    type = scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE());
    components = std::max(1, scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()));
    if (this->Mode == Resample)
    {
      components = this->Interpolator->ComputeNumberOfComponents(components);
    }
    vtkDataObject::SetPointDataActiveScalarInfo(outInfo, type, components);
  }
  if (!bravais::CheckExtent(whole, components * vtkDataArray::GetDataTypeSize(type), why))
  {
    return fail();
  }
  double origin[3];
  placement.GetOrigin(grid, origin);
  outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  outInfo->Set(vtkDataObject::ORIGIN(), origin, 3);
  outInfo->Set(vtkDataObject::SPACING(), placement.Spacing, 3);
  outInfo->CopyEntry(inInfo, vtkDataObject::DIRECTION());
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkImageToBCCVolume::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  int extent[6];
  bravais::GetPieceExtent(outputVector->GetInformationObject(0), extent);
  if (!IsEmpty(extent)) // nothing is made of nothing
  {
    bravais::ImageGrid grid;
    bravais::BCCPlacement placement;
    std::string why;
    if (!this->Place(inInfo, grid, placement, why))
    {
      return this->Fail(outputVector, why);
    }
    this->GetInputExtent(grid, placement, extent, extent);
  }
  bravais::RequestExtent(inInfo, extent);
  return 1;
}

//------------------------------------------------------------------------------
int vtkImageToBCCVolume::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inInfo);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  vtkBCCLattice::Tag(output);
  if (IsEmpty(extent))
  {
    return 1; // a piece without points
  }

  bravais::ImageGrid grid;
  bravais::BCCPlacement placement;
  std::string why;
  if (!input)
  {
    return this->Fail(outputVector, "There is no input image; a volume was expected.");
  }
  if (!this->Place(inInfo, grid, placement, why))
  {
    return this->Fail(outputVector, why);
  }
  for (const char* tag : { bravais::BCCTag, bravais::Rank1Tag })
  {
    if (bravais::HasLatticeTag(input, tag))
    {
      return this->Fail(outputVector,
        std::string("The input is tagged as an image of the lattice ") + tag +
          "; a Cartesian image was expected.");
    }
  }
  int needed[6];
  this->GetInputExtent(grid, placement, extent, needed);
  vtkDataArray* scalars = input->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() < input->GetNumberOfPoints() ||
    !Covers(input->GetExtent(), needed))
  {
    return this->Fail(outputVector,
      scalars ? "The input's scalars are fewer than the points that were asked for."
              : "The input has no point scalars; they are what is sampled.");
  }
  if (this->Mode == Subset && !bravais::CheckPointArrays(input, why))
  {
    return this->Fail(outputVector, why);
  }
  if (this->Mode == Resample && !bravais::IsNumberType(scalars->GetDataType()))
  {
    return this->Fail(outputVector,
      std::string("The input's scalars are of type ") + scalars->GetDataTypeAsString() +
        "; numbers of 8 to 64 bits were expected.");
  }
  if (!bravais::CheckMemory(
        extent, scalars->GetNumberOfComponents() * scalars->GetDataTypeSize(), why))
  {
    return this->Fail(outputVector, why);
  }
  output->SetExtent(extent);
  const int first[3] = { grid.Whole[0], grid.Whole[2], grid.Whole[4] };
  const bool finished = this->Mode == Subset ? bravais::CopySubset(this, input, first, output)
                                             : this->ResampleScalars(input, placement, output);
  if (!finished)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkImageToBCCVolume::ResampleScalars(
  vtkImageData* input, const bravais::BCCPlacement& placement, vtkImageData* output)
{
  vtkAbstractImageInterpolator* interpolator = this->Interpolator;
  int reach[3];
  GetReach(interpolator, placement, reach); // for the sampling that the interpolator learns
  output->AllocateScalars(input->GetScalarType(),
    interpolator->ComputeNumberOfComponents(input->GetNumberOfScalarComponents()));
  output->GetPointData()->GetScalars()->SetName(input->GetPointData()->GetScalars()->GetName());

  const bool filter = this->LowPass && placement.IsDecimation();
  vtkSmartPointer<vtkImageData> source = input;
  if (filter)
  {
    source = bravais::FilterLowPass(this, source, placement, 0.0, 0.6);
  }
  if (!source)
  {
    return false;
  }
  if (bravais::NeedsCoefficients(interpolator))
  {
    source = bravais::ComputeCoefficients(
      source, interpolator, bravais::GetArithmeticType(input->GetScalarType()));
  }
  return !this->GetAbortExecute() &&
    bravais::Interpolate(this, source, interpolator, placement, output, filter ? 0.7 : 0.2, 1.0);
}

//------------------------------------------------------------------------------
void vtkImageToBCCVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->Dimensions;
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  os << indent << "Dimensions: (" << n[0] << ", " << n[1] << ", " << n[2] << ")\n";
  os << indent << "SampleRatio: " << this->SampleRatio << "\n";
  os << indent << "Interpolator: " << this->Interpolator.Get() << "\n";
  os << indent << "LowPass: " << (this->LowPass ? "On" : "Off") << "\n";
}
