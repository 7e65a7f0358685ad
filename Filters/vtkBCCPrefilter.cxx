// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCPrefilter.h"

#include "BCCBlock.h"
#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "BCCKernel.h"
#include "BCCPrefilter.h"
#include "PieceRequest.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkBCCPrefilter);

namespace
{
/// The samples that the coefficients for `extent` need.
bravais::BCCExtent GetNeededExtent(
  int method, const bravais::BCCExtent& whole, const bravais::BCCExtent& extent)
{
  if (bravais::NeedsWholeVolume(method))
  {
    return whole;
  }
  return method == vtkBCCPrefilter::None ? extent : bravais::GrowWithin(whole, extent);
}
}

//------------------------------------------------------------------------------
const char* vtkBCCPrefilter::GetMethodAsString()
{
  const auto method = bravais::ToBCCPrefilter(this->Method);
  return method ? bravais::GetName(*method) : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkBCCPrefilter::GetKernelAsString()
{
  const auto kernel = bravais::ToBCCKernel(this->Kernel);
  return kernel ? bravais::GetName(*kernel) : "Unknown";
}

//------------------------------------------------------------------------------
int vtkBCCPrefilter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCPrefilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool blocks = !vtkImageData::GetData(outputs); // each of which is asked by itself
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  in->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  std::string why;
  if (!bravais::CheckBCCSpline(this->Kernel, this->Method, why) ||
    (!blocks && !bravais::CheckExtent(whole, 1, why)))
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputs);
    return 0;
  }
  if (blocks)
  {
    return 1;
  }
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    in, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (scalars && scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
  {
    vtkDataObject::SetPointDataActiveScalarInfo(
      out, bravais::GetBCCCoefficientType(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE())), -1);
  }
  if (in->Has(vtkDataObject::DIRECTION())) // which VTK does not pass on, unlike ORIGIN and SPACING
  {
    out->CopyEntry(in, vtkDataObject::DIRECTION());
  }
  out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCPrefilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  bravais::BCCExtent whole = { 0, -1, 0, -1, 0, -1 };
  bravais::BCCExtent extent;
  in->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  bravais::GetPieceExtent(outputs->GetInformationObject(0), extent.data());
  if (!bravais::IsEmpty(extent))
  {
    extent = GetNeededExtent(this->Method, whole, extent);
  }
  bravais::RequestExtent(in, extent.data());
  return 1;
}

//------------------------------------------------------------------------------
bool vtkBCCPrefilter::HasKept(vtkImageData* input, const std::array<int, 6>& extent) const
{
  const Whole& kept = this->Kept;
  return kept.Coefficients && input && kept.Input == input && kept.InputTime == input->GetMTime() &&
    kept.Extent == extent && kept.Method == this->Method && kept.Kernel == this->Kernel;
}

//------------------------------------------------------------------------------
int vtkBCCPrefilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  vtkInformation* out = outputs->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(in);
  vtkImageData* output = vtkImageData::GetData(out);
  bravais::BCCExtent whole = { 0, -1, 0, -1, 0, -1 };
  bravais::BCCExtent extent;
  in->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  out->Get(Pipeline::UPDATE_EXTENT(), extent.data());
  if (bravais::IsEmpty(extent))
  {
    return 1; // a piece without points
  }
  if (!this->HasKept(input, whole))
  {
    this->Kept = Whole();
  }
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  std::string why;
  if (!bravais::CheckBCCImage(input, whole.data(), why))
  {
    return fail(why);
  }
  vtkDataArray* scalars = input->GetPointData()->GetScalars();
  const int components = scalars->GetNumberOfComponents();
  const int type = bravais::GetBCCCoefficientType(scalars->GetDataType());
  // A spectral method makes the whole volume, of which what was asked for is put out.
  const bravais::BCCExtent piece = extent;
  const bool spectral = bravais::NeedsWholeVolume(this->Method);
  if (spectral)
  {
    extent = whole;
  }
  if (!bravais::CheckMemory(extent.data(), components * vtkDataArray::GetDataTypeSize(type), why))
  {
    return fail(why);
  }
  if (!bravais::Contains(
        bravais::ToBCCExtent(input->GetExtent()), GetNeededExtent(this->Method, whole, extent)))
  {
    return fail("The input does not hold the extent that it was asked for.");
  }
  output->SetExtent(extent.data());
  vtkSmartPointer<vtkDataArray> coefficients = this->Kept.Coefficients;
  if (coefficients)
  {
    output->GetPointData()->SetScalars(coefficients);
    this->UpdateProgress(1.0);
  }
  else
  {
    output->AllocateScalars(type, components);
    coefficients = output->GetPointData()->GetScalars();
    coefficients->SetName(scalars->GetName());
    std::atomic<bool> finite(true);
    if (!bravais::ComputeBCCCoefficients(this, input, whole.data(), this->Kernel, this->Method,
          coefficients, extent.data(), 0.0, 1.0, &finite))
    {
      output->Initialize();
      return 1;
    }
    why = finite ? std::string() : bravais::ExplainBCCCoefficients(scalars, coefficients);
    if (!why.empty())
    {
      return fail(why);
    }
  }
  const bool last = piece[1] == whole[1] && piece[3] == whole[3] && piece[5] == whole[5];
  this->Kept = spectral && !last && !this->GetReleaseDataFlag()
    ? Whole{ coefficients, input, input->GetMTime(), whole, this->Method, this->Kernel }
    : Whole();
  output->Crop(piece.data());
  return 1;
}

//------------------------------------------------------------------------------
void vtkBCCPrefilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "Kernel: " << this->GetKernelAsString() << "\n";
  os << indent << "Kept Coefficients: " << this->Kept.Coefficients.Get() << "\n";
}
