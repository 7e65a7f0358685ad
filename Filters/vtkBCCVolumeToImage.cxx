// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeToImage.h"

#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "BCCGridSampler.h"
#include "BCCKernel.h"
#include "BCCPrefilter.h"
#include "PieceRequest.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkBCCVolumeToImage);

//------------------------------------------------------------------------------
const char* vtkBCCVolumeToImage::GetKernelAsString()
{
  const auto kernel = bravais::ToBCCKernel(this->Kernel);
  return kernel ? bravais::GetName(*kernel) : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeToImage::GetPrefilterAsString()
{
  const auto prefilter = bravais::ToBCCPrefilter(this->Prefilter);
  return prefilter ? bravais::GetName(*prefilter) : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeToImage::GetOutputScalarTypeAsString()
{
  return this->OutputScalarType == -1 ? "input"
                                      : vtkImageScalarTypeNameMacro(this->OutputScalarType);
}

//------------------------------------------------------------------------------
int vtkBCCVolumeToImage::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

namespace
{

/// The output's grid over the box of an input of extent `whole` and spacing `s`.
struct Grid
{
  int Dimensions[3];
  double Spacing[3];
  double Origin[3]; ///< from the input's origin, along the image's axes

  bool Set(const int whole[6], const double s[3], const int wanted[3], std::string& why)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = s[axis] *
        (static_cast<double>(whole[2 * axis + 1]) - whole[2 * axis] + (axis < 2 ? 0.5 : 0.0));
      const double count = wanted[axis] != 0 ? wanted[axis] : std::floor(length / s[2] + 0.5) + 1.0;
      if (!(count >= 1.0 && count < VTK_INT_MAX / 2))
      {
        std::ostringstream text;
        text << "OutputDimensions are " << wanted[0] << ", " << wanted[1] << ", " << wanted[2]
             << ", which stands for " << count << " points along "
             << "xyz"[axis] << "; 1 to 2^30 were expected, or 0 for the input's spacing.";
        why = text.str();
        return false;
      }
      this->Dimensions[axis] = static_cast<int>(count);
      const bool single = this->Dimensions[axis] == 1;
      this->Spacing[axis] = single ? length : length / (count - 1.0);
      this->Origin[axis] = s[axis] * whole[2 * axis] + (single ? 0.5 * length : 0.0);
    }
    return true;
  }
};

} // namespace

//------------------------------------------------------------------------------
bool vtkBCCVolumeToImage::CheckParameters(bool blocks, std::string& why) const
{
  const int* n = this->OutputDimensions;
  if (n[0] < 0 || n[1] < 0 || n[2] < 0)
  {
    why = "OutputDimensions are " + std::to_string(n[0]) + ", " + std::to_string(n[1]) + ", " +
      std::to_string(n[2]) + "; positive numbers were expected, or 0 for the input's spacing.";
    return false;
  }
  if (this->OutputScalarType != -1 && !bravais::IsNumberType(this->OutputScalarType))
  {
    why = "OutputScalarType is " + std::to_string(this->OutputScalarType) +
      "; a VTK number type from VTK_CHAR to VTK_DOUBLE, or -1, was expected.";
    return false;
  }
  const int extent[6] = { 0, std::max(1, n[0]) - 1, 0, std::max(1, n[1]) - 1, 0,
    std::max(1, n[2]) - 1 };
  // Blocks are made whole, others maybe piece by piece.
  return bravais::CheckExtent(extent, 8, why) &&
    (!blocks || bravais::CheckMemory(extent, 1, why)) &&
    bravais::CheckBCCSpline(this->Kernel, this->Prefilter, why);
}

//------------------------------------------------------------------------------
int vtkBCCVolumeToImage::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::string why;
  const auto fail = [&]
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputs);
    return 0;
  };
  const bool blocks = !vtkImageData::GetData(outputs);
  if (!this->CheckParameters(blocks, why))
  {
    return fail();
  }
  if (blocks)
  {
    return 1; // each is asked by itself
  }
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  double s[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  double direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  if (in->Has(vtkDataObject::SPACING()))
  {
    in->Get(vtkDataObject::SPACING(), s);
  }
  if (in->Has(vtkDataObject::ORIGIN()))
  {
    in->Get(vtkDataObject::ORIGIN(), origin);
  }
  if (in->Has(vtkDataObject::DIRECTION()))
  {
    in->Get(vtkDataObject::DIRECTION(), direction);
  }
  Grid grid;
  if (!bravais::CheckExtent(whole, 1, why) || !bravais::CheckPlacement(origin, s, why) ||
    !grid.Set(whole, s, this->OutputDimensions, why))
  {
    return fail();
  }
  double offset[3];
  vtkMatrix3x3::MultiplyPoint(direction, grid.Origin, offset);
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] += offset[axis];
  }
  const int* n = grid.Dimensions;
  const int extent[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  if (!bravais::CheckExtent(extent, 8, why))
  {
    return fail();
  }
  out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  out->Set(vtkDataObject::SPACING(), grid.Spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  out->Set(vtkDataObject::DIRECTION(), direction, 9);
  out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  if (this->OutputScalarType != -1)
  {
    vtkDataObject::SetPointDataActiveScalarInfo(out, this->OutputScalarType, -1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCVolumeToImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  int outWhole[6];
  int extent[6];
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  out->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), outWhole);
  bravais::GetPieceExtent(out, extent);
  if (bravais::IsEmpty(bravais::ToBCCExtent(extent)))
  {
    bravais::RequestExtent(in, extent);
    return 1;
  }
  if (bravais::NeedsWholeVolume(this->Prefilter))
  {
    bravais::RequestExtent(in, whole);
    return 1;
  }
  const int dimensions[3] = { outWhole[1] + 1, outWhole[3] + 1, outWhole[5] + 1 };
  bravais::BCCGridSampler sampler(
    bravais::ToBCCExtent(whole), dimensions, bravais::ToBCCExtent(extent));
  sampler.SetQuasiInterpolation(
    this->Prefilter == static_cast<int>(bravais::BCCPrefilter::QuasiInterpolation));
  bravais::RequestExtent(in, sampler.GetInputExtent().data());
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCVolumeToImage::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(in);
  vtkImageData* output = vtkImageData::GetData(out);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  int outWhole[6];
  int extent[6];
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  out->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), outWhole);
  out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  output->GetFieldData()->RemoveArray("Lattice"); // passed from the input, but not true of it
  const bravais::BCCExtent piece = bravais::ToBCCExtent(extent);
  if (bravais::IsEmpty(piece))
  {
    return 1; // a piece without points
  }
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  std::string why;
  if (!bravais::CheckBCCImage(input, whole, why))
  {
    return fail(why);
  }
  vtkDataArray* scalars = input->GetPointData()->GetScalars();
  const int components = scalars->GetNumberOfComponents();
  const int type = this->OutputScalarType == -1 ? scalars->GetDataType() : this->OutputScalarType;
  const int coefficientType = bravais::GetBCCCoefficientType(scalars->GetDataType());
  const int size = vtkDataArray::GetDataTypeSize(type);
  const int coefficientSize = vtkDataArray::GetDataTypeSize(coefficientType);
  const int bytes = components * (size + (this->ComputeGradients ? 3 * coefficientSize : 0));
  if (!bravais::CheckMemory(extent, bytes, why))
  {
    return fail(why);
  }

  const int dimensions[3] = { outWhole[1] + 1, outWhole[3] + 1, outWhole[5] + 1 };
  bravais::BCCGridSampler sampler(bravais::ToBCCExtent(whole), dimensions, piece);
  sampler.SetKernel(*bravais::ToBCCKernel(this->Kernel));
  sampler.SetQuasiInterpolation(
    this->Prefilter == static_cast<int>(bravais::BCCPrefilter::QuasiInterpolation));
  if (!sampler.IsLayerSmallEnough())
  {
    return fail("A layer of the piece has more than 2^28 samples; ask for smaller pieces.");
  }
  int held[6];
  input->GetExtent(held);
  if (!bravais::Contains(bravais::ToBCCExtent(held),
        bravais::NeedsWholeVolume(this->Prefilter) ? bravais::ToBCCExtent(whole)
                                                   : sampler.GetInputExtent()))
  {
    return fail("The input does not hold the extent that it was asked for.");
  }
  double share = 0.0;
  vtkSmartPointer<vtkDataArray> source = scalars;
  if (bravais::NeedsWholeVolume(this->Prefilter))
  {
    share = 0.5;
    source.TakeReference(vtkDataArray::CreateDataArray(coefficientType));
    source->SetNumberOfComponents(components);
    source->SetNumberOfTuples(input->GetNumberOfPoints());
    std::copy_n(whole, 6, held);
    if (!bravais::ComputeBCCCoefficients(
          this, input, whole, this->Kernel, this->Prefilter, source, whole, 0.0, share))
    {
      output->Initialize();
      return 1;
    }
  }

  output->SetExtent(extent);
  output->AllocateScalars(type, components);
  vtkDataArray* values = output->GetPointData()->GetScalars();
  values->SetName(scalars->GetName());
  vtkSmartPointer<vtkDataArray> gradients;
  if (this->ComputeGradients)
  {
    gradients.TakeReference(vtkDataArray::CreateDataArray(coefficientType));
    gradients->SetName("Gradients");
    gradients->SetNumberOfComponents(3 * components);
    gradients->SetNumberOfTuples(output->GetNumberOfPoints());
    output->GetPointData()->AddArray(gradients);
    // World derivatives of the lattice coordinates, X = 2 x / s.x and so on, then the axes.
    const double* s = input->GetSpacing();
    const double scale[3] = { 2.0 / s[0], 2.0 / s[1], 1.0 / s[2] };
    const double* direction = input->GetDirectionMatrix()->GetData();
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        sampler.SetGradientMatrix(row, column, direction[3 * row + column] * scale[column]);
      }
    }
  }
  if (!sampler.Execute(this, source, bravais::ToBCCExtent(held), values, gradients, share))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeToImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputDimensions: (" << this->OutputDimensions[0] << ", "
     << this->OutputDimensions[1] << ", " << this->OutputDimensions[2] << ")\n";
  os << indent << "Kernel: " << this->GetKernelAsString() << "\n";
  os << indent << "Prefilter: " << this->GetPrefilterAsString() << "\n";
  os << indent << "ComputeGradients: " << (this->ComputeGradients ? "On" : "Off") << "\n";
  os << indent << "OutputScalarType: " << this->GetOutputScalarTypeAsString() << "\n";
}
