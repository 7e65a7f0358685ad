// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureRows.h"

#include "Rank1Resample.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace bravais
{

//------------------------------------------------------------------------------
PictureRows::PictureRows(vtkAlgorithm* source, int port, Rank1Boundary boundary)
  : Source(source)
  , Port(port)
  , Boundary(boundary)
{
  source->GetOutputInformation(port)->Get(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Whole);
}

//------------------------------------------------------------------------------
int PictureRows::Wrap(int place, int count) const
{
  switch (this->Boundary)
  {
    case Rank1Boundary::Periodic:
      return static_cast<int>(Modulo(place, count));
    case Rank1Boundary::Clamp:
      return std::clamp(place, 0, count - 1);
    default:
    {
      const auto rest = static_cast<int>(Modulo(place, 2 * std::int64_t{ count }));
      return rest < count ? rest : 2 * count - 1 - rest;
    }
  }
}

//------------------------------------------------------------------------------
bool PictureRows::Begin(std::string& why)
{
  this->Type = VTK_VOID;
  return this->Fetch(0, 1, why);
}

//------------------------------------------------------------------------------
bool PictureRows::Fetch(int first, int last, std::string& why)
{
  this->First = first;
  this->Values.resize(static_cast<std::size_t>(last - first) * this->RowBytes);
  const int height = this->GetHeight();
  // What is inside in one go, and what is beyond each border in another.
  for (const auto& [begin, end] : { std::pair{ first, std::min(last, 0) },
         std::pair{ std::max(first, 0), std::min(last, height) },
         std::pair{ std::max(first, height), last } })
  {
    if (begin < end && !this->FetchPart(begin, end, why))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PictureRows::FetchPart(int first, int last, std::string& why)
{
  int low = VTK_INT_MAX;
  int high = 0;
  for (int row = first; row < last; ++row)
  {
    const int place = this->Wrap(row, this->GetHeight());
    low = std::min(low, place);
    high = std::max(high, place);
  }
  int extent[6];
  std::copy_n(this->Whole, 6, extent);
  extent[2] = this->Whole[2] + low;
  extent[3] = this->Whole[2] + high;
  vtkNew<vtkInformation> request;
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  vtkNew<vtkInformationVector> requests;
  requests->SetInformationObject(this->Port, request);
  if (!this->Source->Update(this->Port, requests))
  {
    why.clear(); // the source has told why
    return false;
  }
  auto* image = vtkImageData::SafeDownCast(this->Source->GetOutputDataObject(this->Port));
  if (!image || !CheckRank1Input(image, why))
  {
    return false;
  }
  int held[6];
  image->GetExtent(held);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (this->Type == VTK_VOID)
  {
    this->Type = scalars->GetDataType();
    this->Components = scalars->GetNumberOfComponents();
    this->RowBytes =
      static_cast<std::size_t>(this->GetWidth()) * this->Components * scalars->GetDataTypeSize();
    this->Values.resize(static_cast<std::size_t>(last - first) * this->RowBytes);
  }
  if (held[0] > extent[0] || held[1] < extent[1] || held[2] > extent[2] || held[3] < extent[3] ||
    scalars->GetDataType() != this->Type || scalars->GetNumberOfComponents() != this->Components)
  {
    why = "The input does not hold the extent that it was asked for.";
    return false;
  }
  for (int row = first; row < last; ++row)
  {
    int ijk[3] = { extent[0], this->Whole[2] + this->Wrap(row, this->GetHeight()), held[4] };
    const auto* from = static_cast<const char*>(
      scalars->GetVoidPointer(image->ComputePointId(ijk) * this->Components));
    std::copy_n(from, this->RowBytes,
      this->Values.data() + static_cast<std::size_t>(row - this->First) * this->RowBytes);
  }
  return true;
}

} // namespace bravais
