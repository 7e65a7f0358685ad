// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1ImageReconstruct.h"

#include "ImageChecks.h"
#include "PieceRequest.h"
#include "Rank1Image.h"
#include "Rank1LookUp.h"
#include "RoundTo.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkRank1ImageReconstruct);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Pixels along each axis, by what is wanted of an image.
bool FindDimensions(
  const bravais::Rank1Image& image, const int wanted[2], int dimensions[2], std::string& why)
{
  const double width = image.Domain[1] - image.Domain[0];
  const double height = image.Domain[3] - image.Domain[2];
  const double texels =
    static_cast<double>(image.Lattice.GetNumberOfPoints()) * image.Tiles[0] * image.Tiles[1];
  double w = wanted[0];
  double h = wanted[1];
  if (wanted[0] == 0)
  {
    w = std::max(
      1.0, std::floor((h != 0.0 ? h * width / height : std::sqrt(texels * width / height)) + 0.5));
  }
  if (wanted[1] == 0)
  {
    h = std::max(1.0, std::floor(w * height / width + 0.5));
  }
  constexpr int most = VTK_INT_MAX / 2;
  if (!(w >= 1.0 && h >= 1.0 && w <= most && h <= most))
  {
    std::ostringstream text;
    text << "OutputDimensions are " << wanted[0] << " x " << wanted[1] << ", which stands for " << w
         << " x " << h << " pixels; 1 to " << most
         << " each way were expected, or 0 for square pixels.";
    why = text.str();
    return false;
  }
  dimensions[0] = static_cast<int>(w);
  dimensions[1] = static_cast<int>(h);
  return true;
}

/// Whether an input is there, all of it and as its source now makes it. A source of many blocks is
/// not to be asked for them while they are handed in one by one.
bool IsCurrent(vtkExecutive* source, vtkInformation* in)
{
  vtkImageData* image = vtkImageData::GetData(in);
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(source);
  const int* whole = Pipeline::GetWholeExtent(in);
  return image && pipeline && image->GetMTime() >= pipeline->GetPipelineMTime() &&
    std::equal(whole, whole + 6, image->GetExtent());
}

/// Pixels of a part of a picture of so many pixels. False when the filter was aborted.
template <class T>
bool Reconstruct(vtkRank1ImageReconstruct* self, const bravais::Rank1Image& image,
  const int dimensions[2], const int extent[6], const T* texels, T* pixels)
{
  const auto texture =
    bravais::MakeRank1Texture<double>(image.Lattice, image.Tiles[0], image.Tiles[1]);
  const auto interpolation = static_cast<bravais::Rank1Interpolation>(self->GetInterpolation());
  const int components = image.Texels->GetNumberOfComponents();
  const int side = self->GetSamplesPerAxis();
  const double weight = 1.0 / (static_cast<double>(side) * side);
  const vtkIdType columns = vtkIdType{ extent[1] } - extent[0] + 1;
  const auto work = [&](int y)
  {
    T* pixel = pixels + (y - extent[2]) * columns * components;
    std::vector<double> sum(components);
    for (int x = extent[0]; x <= extent[1]; ++x, pixel += components)
    {
      if (side == 1 && interpolation == bravais::Rank1Interpolation::Nearest)
      {
        const glm::dvec2 uv((x + 0.5) / dimensions[0], (y + 0.5) / dimensions[1]);
        std::copy_n(
          texels + bravais::FindRank1Nearest(texture, uv) * components, components, pixel);
        continue;
      }
      std::fill(sum.begin(), sum.end(), 0.0);
      for (int sample = 0; sample < side * side; ++sample)
      {
        const glm::dvec2 uv((x + (sample % side + 0.5) / side) / dimensions[0],
          (y + (sample / side + 0.5) / side) / dimensions[1]);
        bravais::AddRank1Value(texture, interpolation, uv, texels, components, weight, sum.data());
      }
      for (int c = 0; c < components; ++c)
      {
        pixel[c] = bravais::RoundTo<T>(sum[c]);
      }
    }
  };
  return bravais::ForEachSlice(self, extent[2], extent[3], work);
}

} // namespace

//------------------------------------------------------------------------------
const char* vtkRank1ImageReconstruct::GetInterpolationAsString()
{
  constexpr const char* names[] = { "Nearest", "Bilinear", "Barycentric", "BoxSpline" };
  return names[this->Interpolation];
}

//------------------------------------------------------------------------------
bool vtkRank1ImageReconstruct::CheckParameters(bool blocks, std::string& why) const
{
  const int* n = this->OutputDimensions;
  if (this->SamplesPerAxis < 1 || this->SamplesPerAxis > 256)
  {
    why = "SamplesPerAxis is " + std::to_string(this->SamplesPerAxis) + "; 1 to 256 were expected.";
    return false;
  }
  if (n[0] < 0 || n[1] < 0)
  {
    why = "OutputDimensions are " + std::to_string(n[0]) + " x " + std::to_string(n[1]) +
      "; positive numbers were expected, or 0 for square pixels.";
    return false;
  }
  const int extent[6] = { 0, std::max(1, n[0]) - 1, 0, std::max(1, n[1]) - 1, 0, 0 };
  // Blocks are made whole, others maybe piece by piece.
  return blocks ? bravais::CheckMemory(extent, 1, why) : bravais::CheckExtent(extent, 1, why);
}

//------------------------------------------------------------------------------
int vtkRank1ImageReconstruct::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
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
  vtkInformation* out = outputVector->GetInformationObject(0);
  if (!IsCurrent(this->GetInputExecutive(0, 0), inputVector[0]->GetInformationObject(0)))
  {
    this->GetInputAlgorithm()->UpdateWholeExtent(); // the domain is among the data
  }
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  int dimensions[2] = { 0, 0 };
  const auto image = bravais::ReadRank1Image(input, why);
  if (!image || !FindDimensions(*image, this->OutputDimensions, dimensions, why))
  {
    return fail();
  }
  double direction[9];
  double inverse[9];
  double origin[3];
  double spacing[3] = { 1.0, 1.0, 1.0 };
  std::copy_n(input->GetDirectionMatrix()->GetData(), 9, direction);
  vtkMatrix3x3::Invert(direction, inverse);
  vtkMatrix3x3::MultiplyPoint(inverse, input->GetOrigin(), origin);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double* side = image->Domain + 2 * axis;
    spacing[axis] = (side[1] - side[0]) / dimensions[axis];
    origin[axis] = side[0] + 0.5 * spacing[axis];
  }
  vtkMatrix3x3::MultiplyPoint(direction, origin, origin);
  const int extent[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, 0 };
  out->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  out->Set(vtkDataObject::SPACING(), spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  out->Set(vtkDataObject::DIRECTION(), direction, 9);
  out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(
    out, image->Texels->GetDataType(), image->Texels->GetNumberOfComponents());
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageReconstruct::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  bravais::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageReconstruct::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* out = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(out);
  int whole[6];
  int extent[6];
  out->Get(Pipeline::WHOLE_EXTENT(), whole);
  out->Get(Pipeline::UPDATE_EXTENT(), extent);
  for (const char* mark : { "Lattice", "Rank1.Generator", "Rank1.Domain" })
  {
    output->GetFieldData()->RemoveArray(mark); // passed from the input, but not true of it
  }
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece without pixels
  }
  std::string why;
  const auto image = bravais::ReadRank1Image(input, why);
  if (!image ||
    !bravais::CheckMemory(
      extent, image->Texels->GetNumberOfComponents() * image->Texels->GetDataTypeSize(), why))
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  const int dimensions[2] = { whole[1] + 1, whole[3] + 1 };
  output->SetExtent(extent);
  output->AllocateScalars(image->Texels->GetDataType(), image->Texels->GetNumberOfComponents());
  vtkDataArray* pixels = output->GetPointData()->GetScalars();
  pixels->SetName(image->Texels->GetName());
  bool finished = false;
  switch (pixels->GetDataType())
  {
    vtkTemplateMacro(finished = Reconstruct(this, *image, dimensions, extent,
                       static_cast<const VTK_TT*>(image->Texels->GetVoidPointer(0)),
                       static_cast<VTK_TT*>(pixels->GetVoidPointer(0))));
  }
  if (!finished)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1ImageReconstruct::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputDimensions: (" << this->OutputDimensions[0] << ", "
     << this->OutputDimensions[1] << ")\n";
  os << indent << "Interpolation: " << this->GetInterpolationAsString() << "\n";
  os << indent << "SamplesPerAxis: " << this->SamplesPerAxis << "\n";
}
