// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCLattice.h"

#include "BCCLattice.h"
#include "BoxSpline.h"
#include "LatticeTag.h"

#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkBCCLattice);

namespace
{
bool CheckImage(vtkImageData* image, const char* helper)
{
  if (!image)
  {
    vtkErrorWithObjectMacro(nullptr, "vtkBCCLattice::" << helper << " expects an image, not none.");
  }
  return image != nullptr;
}

// The marks of a piece.
const char* const WholeName = "BCC.WholeExtent";
const char* const PieceName = "BCC.PieceExtent";

std::string GetRangeName(const char* array)
{
  return std::string("BCC.WholeRange.") + (array ? array : "");
}

void MarkExtent(vtkImageData* image, const char* name, const int extent[6])
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(6);
  std::copy_n(extent, 6, array->GetPointer(0));
  image->GetFieldData()->AddArray(array);
}

bool FindExtent(vtkImageData* image, const char* name, int extent[6])
{
  auto* array = vtkIntArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() != 6)
  {
    return false;
  }
  std::copy_n(array->GetPointer(0), 6, extent);
  return true;
}
}

//------------------------------------------------------------------------------
void vtkBCCLattice::Tag(vtkImageData* image)
{
  if (!CheckImage(image, "Tag"))
  {
    return;
  }
  bravais::TagLattice(image, bravais::BCCTag);
}

//------------------------------------------------------------------------------
bool vtkBCCLattice::IsBCC(vtkDataObject* data)
{
  return bravais::HasLatticeTag(data, bravais::BCCTag);
}

//------------------------------------------------------------------------------
void vtkBCCLattice::GetPoint(vtkImageData* image, const int ijk[3], double x[3])
{
  if (!CheckImage(image, "GetPoint"))
  {
    return;
  }
  const double half = 0.5 * bravais::BCCLattice::GetCoset(ijk[2]);
  image->TransformContinuousIndexToPhysicalPoint(ijk[0] + half, ijk[1] + half, ijk[2], x);
}

//------------------------------------------------------------------------------
void vtkBCCLattice::GetBox(vtkImageData* image, double bounds[6])
{
  if (!CheckImage(image, "GetBox"))
  {
    return;
  }
  int whole[6];
  int extent[6];
  if (!GetPiece(image, whole, extent))
  {
    image->GetExtent(extent);
    std::copy_n(extent, 6, whole);
  }
  vtkBoundingBox box;
  if (extent[0] <= extent[1] && extent[2] <= extent[3] && extent[4] <= extent[5])
  {
    const double far[2] = { extent[1] + (extent[1] == whole[1] ? 0.5 : 0.0),
      extent[3] + (extent[3] == whole[3] ? 0.5 : 0.0) };
    for (int corner = 0; corner < 8; ++corner)
    {
      double x[3];
      image->TransformContinuousIndexToPhysicalPoint(corner & 1 ? far[0] : extent[0],
        corner & 2 ? far[1] : extent[2], corner & 4 ? extent[5] : extent[4], x);
      box.AddPoint(x);
    }
    box.GetBounds(bounds);
  }
  else
  {
    vtkMath::UninitializeBounds(bounds);
  }
}

//------------------------------------------------------------------------------
void vtkBCCLattice::MarkPiece(vtkImageData* image, const int whole[6], const int piece[6])
{
  if (CheckImage(image, "MarkPiece"))
  {
    MarkExtent(image, WholeName, whole);
    MarkExtent(image, PieceName, piece);
  }
}

//------------------------------------------------------------------------------
bool vtkBCCLattice::GetPiece(vtkImageData* image, int whole[6], int piece[6])
{
  return CheckImage(image, "GetPiece") && FindExtent(image, WholeName, whole) &&
    FindExtent(image, PieceName, piece);
}

//------------------------------------------------------------------------------
void vtkBCCLattice::MarkWholeRange(
  vtkImageData* image, const char* name, int component, const double range[2])
{
  if (!CheckImage(image, "MarkWholeRange") || component < 0)
  {
    return;
  }
  vtkFieldData* fields = image->GetFieldData();
  const std::string key = GetRangeName(name);
  vtkSmartPointer<vtkDoubleArray> ranges =
    vtkDoubleArray::SafeDownCast(fields->GetAbstractArray(key.c_str()));
  if (!ranges)
  {
    ranges = vtkSmartPointer<vtkDoubleArray>::New();
    ranges->SetName(key.c_str());
    ranges->SetNumberOfComponents(2);
    fields->AddArray(ranges);
  }
  while (ranges->GetNumberOfTuples() <= component)
  {
    ranges->InsertNextTuple2(0.0, -1.0); // none
  }
  ranges->SetTuple(component, range);
  ranges->Modified();
}

//------------------------------------------------------------------------------
bool vtkBCCLattice::GetWholeRange(
  vtkImageData* image, const char* name, int component, double range[2])
{
  auto* ranges = CheckImage(image, "GetWholeRange")
    ? vtkDoubleArray::SafeDownCast(
        image->GetFieldData()->GetAbstractArray(GetRangeName(name).c_str()))
    : nullptr;
  if (!ranges || ranges->GetNumberOfComponents() != 2 || component < 0 ||
    component >= ranges->GetNumberOfTuples())
  {
    return false;
  }
  ranges->GetTuple(component, range);
  return range[0] <= range[1];
}

//------------------------------------------------------------------------------
double vtkBCCLattice::Evaluate(int kernel, double x, double y, double z)
{
  const auto known = bravais::ToBCCKernel(kernel);
  if (!known)
  {
    vtkErrorWithObjectMacro(nullptr,
      "vtkBCCLattice::Evaluate expects the kernel BCC4, BCC7, BCC8 or BCC12, not " << kernel
                                                                                   << '.');
    return 0.0;
  }
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorWithObjectMacro(nullptr,
      "vtkBCCLattice::Evaluate expects finite coordinates, not (" << x << ", " << y << ", " << z
                                                                  << ").");
    return 0.0;
  }
  return bravais::EvaluateKernel(*known, { x, y, z });
}

//------------------------------------------------------------------------------
void vtkBCCLattice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
