// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrderedDither.h"

#include "BayerPattern.h"
#include "OrderedDither.h"
#include "PieceRequest.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkOrderedDither);

namespace
{

bool IsEmpty(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

bool CheckRange(const char* name, const double range[2], std::string& why)
{
  if (range[0] < range[1] && vtkMath::IsFinite(range[1] - range[0]))
  {
    return true;
  }
  std::ostringstream text;
  text << name << " is " << range[0] << ", " << range[1]
       << "; two finite numbers in ascending order were expected.";
  why = text.str();
  return false;
}

/// Range of the finite numbers of all components.
void GetScalarRange(vtkDataArray* scalars, double range[2])
{
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -range[0];
  for (int component = 0; component < scalars->GetNumberOfComponents(); ++component)
  {
    double own[2];
    scalars->GetFiniteRange(own, component);
    range[0] = std::min(range[0], own[0]);
    range[1] = std::max(range[1], own[1]);
  }
}

/// Levels of all points of the output. False when the filter was aborted.
template <class T>
bool Quantize(vtkAlgorithm* self, const bravais::OrderedDither& dither, vtkImageData* input,
  const T* scalars, vtkImageData* output)
{
  int from[6];
  int to[6];
  input->GetExtent(from);
  output->GetExtent(to);
  const vtkIdType components = output->GetNumberOfScalarComponents();
  const vtkIdType inColumns = vtkIdType{ from[1] } - from[0] + 1;
  const vtkIdType inRows = vtkIdType{ from[3] } - from[2] + 1;
  const vtkIdType columns = vtkIdType{ to[1] } - to[0] + 1;
  const vtkIdType rows = vtkIdType{ to[3] } - to[2] + 1;
  const vtkIdType allRows = rows * (vtkIdType{ to[5] } - to[4] + 1);
  const bravais::OrderedDitherRows<T> kernel(dither, to[0], columns, static_cast<int>(components));
  auto* levels = static_cast<unsigned char*>(output->GetScalarPointer());

  // Rows of all slices are one sequence, cut into blocks, so that a single slice is shared too.
  constexpr vtkIdType smallestBlock = 16;
  constexpr vtkIdType mostBlocks = 1 << 20;
  const vtkIdType block = std::max(smallestBlock, allRows / mostBlocks + 1);
  const auto work = [&](int index)
  {
    const vtkIdType last = std::min(allRows, (index + vtkIdType{ 1 }) * block);
    for (vtkIdType row = index * block; row < last; ++row)
    {
      const vtkIdType y = to[2] + row % rows;
      const vtkIdType z = to[4] + row / rows;
      const vtkIdType point =
        ((z - from[4]) * inRows + y - from[2]) * inColumns + vtkIdType{ to[0] } - from[0];
      kernel.Execute(scalars + point * components, y, z, levels + row * columns * components);
    }
  };
  return bravais::ForEachSlice(self, 0, static_cast<int>((allRows - 1) / block), work);
}

}

//------------------------------------------------------------------------------
const char* vtkOrderedDither::GetBaseOrderAsString()
{
  return this->BaseOrder == FCC ? "FCC" : "BCC";
}

//------------------------------------------------------------------------------
bool vtkOrderedDither::CheckParameters(std::string& why) const
{
  std::ostringstream text;
  constexpr int bits = bravais::OrderedDither::MaximumLog2NumberOfCells;
  constexpr int levels = bravais::OrderedDither::MaximumLevels;
  if (this->NumberOfLevels < 2 || this->NumberOfLevels > levels)
  {
    text << "NumberOfLevels is " << this->NumberOfLevels << "; 2 to " << levels
         << " were expected.";
  }
  else if (this->Dimensionality != 2 && this->Dimensionality != 3)
  {
    text << "Dimensionality is " << this->Dimensionality << "; 2 or 3 was expected.";
  }
  else if (this->PatternLog2Size < 0 || this->PatternLog2Size > bits / this->Dimensionality)
  {
    text << "PatternLog2Size is " << this->PatternLog2Size << "; for a Dimensionality of "
         << this->Dimensionality << ", 0 to " << bits / this->Dimensionality << " were expected.";
  }
  why = text.str();
  return why.empty() && (!this->HasInputRange() || CheckRange("InputRange", this->InputRange, why));
}

//------------------------------------------------------------------------------
int vtkOrderedDither::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string why;
  if (!this->CheckParameters(why))
  {
    vtkErrorMacro(<< why);
    bravais::RefuseInformation(outputVector);
    return 0;
  }
  if (!vtkImageData::GetData(outputVector))
  {
    return 1; // of many blocks, each of which is asked by itself
  }
  this->Superclass::RequestInformation(request, inputVector, outputVector);
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, -1);
  info->CopyEntry(inputVector[0]->GetInformationObject(0), vtkDataObject::DIRECTION());
  info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkOrderedDither::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  int extent[6];
  bravais::GetPieceExtent(outputVector->GetInformationObject(0), extent);
  if (!this->HasInputRange()) // The range is that of the whole, whatever piece is wanted.
  {
    vtkStreamingDemandDrivenPipeline::GetWholeExtent(info, extent);
  }
  bravais::RequestExtent(info, extent);
  return 1;
}

//------------------------------------------------------------------------------
int vtkOrderedDither::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(info);
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  if (!input || input->GetNumberOfPoints() < 1)
  {
    return fail("The input has no points.");
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_NONE;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputVector, association);
  if (!scalars || association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    scalars->GetNumberOfComponents() < 1 ||
    scalars->GetNumberOfTuples() < input->GetNumberOfPoints())
  {
    return fail("The input has no point scalars, or fewer than points.");
  }
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (IsEmpty(extent))
  {
    return 1; // a piece without points
  }
  double range[2] = { this->InputRange[0], this->InputRange[1] };
  if (!this->HasInputRange())
  {
    GetScalarRange(scalars, range);
    std::string why;
    if (!CheckRange("The scalar range", range, why))
    {
      return fail(why + " InputRange sets another.");
    }
  }
  const auto pattern = bravais::BayerPattern::Create(this->Dimensionality, this->PatternLog2Size,
    this->BaseOrder == FCC ? bravais::BayerPattern::Base::FCC : bravais::BayerPattern::Base::BCC);
  const auto dither =
    bravais::OrderedDither::Create(*pattern, this->NumberOfLevels, range[0], range[1]);

  output->SetExtent(extent);
  output->AllocateScalars(VTK_UNSIGNED_CHAR, scalars->GetNumberOfComponents());
  this->CopyAttributeData(input, output, inputVector);
  bool finished = false;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(finished = Quantize(this, *dither, input,
                       static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), output));
    default:
      return fail(std::string("The scalars are of type ") + scalars->GetDataTypeAsString() +
        "; a type of 8 to 64 bits was expected.");
  }
  if (!finished)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOrderedDither::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "Dimensionality: " << this->Dimensionality << "\n";
  os << indent << "PatternLog2Size: " << this->PatternLog2Size << "\n";
  os << indent << "BaseOrder: " << this->GetBaseOrderAsString() << "\n";
  os << indent << "InputRange: (" << this->InputRange[0] << ", " << this->InputRange[1] << ")\n";
}
