// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeometryImage.h"

#include "ImageChecks.h"
#include "LatticeTag.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <sstream>

namespace bravais
{

namespace
{

std::string Describe(vtkDataArray* array)
{
  std::ostringstream text;
  text << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
       << " components of type " << array->GetDataTypeAsString();
  return text.str();
}

} // namespace

//------------------------------------------------------------------------------
void TagGeometryImage(vtkImageData* image)
{
  TagLattice(image, GeometryImageTag);
  vtkPointData* data = image->GetPointData();
  if (data->GetArray(GeometryImagePoints))
  {
    data->SetActiveVectors(GeometryImagePoints);
  }
}

//------------------------------------------------------------------------------
bool IsGeometryImage(vtkDataObject* data)
{
  return HasLatticeTag(data, GeometryImageTag);
}

//------------------------------------------------------------------------------
bool CheckGeometryImage(vtkImageData* image, std::string& why)
{
  if (!image)
  {
    why = "There is no input; a geometry image was expected.";
    return false;
  }
  if (!IsGeometryImage(image))
  {
    why = "The input is not tagged as a geometry image; its field data need a string array "
          "`Lattice` that holds `GeometryImage`.";
    return false;
  }
  int extent[6];
  image->GetExtent(extent);
  if (image->GetNumberOfPoints() < 1 || extent[4] != extent[5])
  {
    why = "The input's dimensions are " + JoinDimensions(extent) +
      "; a geometry image has at least 1 x 1, and one slice.";
    return false;
  }
  vtkDataArray* points = image->GetPointData()->GetArray(GeometryImagePoints);
  if (!points)
  {
    why = "The input has no point array `Points`; the gixels' positions were expected in it.";
    return false;
  }
  const vtkIdType gixels = image->GetNumberOfPoints();
  const bool plain = vtkFloatArray::SafeDownCast(points) || vtkDoubleArray::SafeDownCast(points);
  if (!plain || points->GetNumberOfComponents() != 3 || points->GetNumberOfTuples() != gixels)
  {
    why = "The array `Points` has " + Describe(points) + "; " + std::to_string(gixels) +
      " tuples of 3 components of type float or double were expected.";
    return false;
  }
  vtkDataArray* defined = image->GetPointData()->GetArray(GeometryImageDefined);
  if (defined &&
    (!vtkUnsignedCharArray::SafeDownCast(defined) || defined->GetNumberOfComponents() != 1 ||
      defined->GetNumberOfTuples() != gixels))
  {
    why = "The array `Defined` has " + Describe(defined) + "; " + std::to_string(gixels) +
      " tuples of 1 component of type unsigned char were expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
GixelView::GixelView(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  this->Width = vtkIdType{ extent[1] } - extent[0] + 1;
  this->Height = vtkIdType{ extent[3] } - extent[2] + 1;
  vtkDataArray* points = image->GetPointData()->GetArray(GeometryImagePoints);
  if (auto* floats = vtkFloatArray::SafeDownCast(points))
  {
    this->Floats = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(points))
  {
    this->Doubles = doubles->GetPointer(0);
  }
  vtkDataArray* defined = image->GetPointData()->GetArray(GeometryImageDefined);
  if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(defined))
  {
    this->Defined = bytes->GetPointer(0);
  }
}

//------------------------------------------------------------------------------
void GetRow(const GixelView& gixels, vtkIdType row, float* points)
{
  for (vtkIdType i = 0; i < gixels.GetWidth(); ++i)
  {
    const vtkIdType gixel = row * gixels.GetWidth() + i;
    double x[3];
    gixels.GetPoint(gixel, x);
    const bool used = gixels.IsUsed(gixel);
    for (int axis = 0; axis < 3; ++axis)
    {
      points[3 * i + axis] =
        used ? static_cast<float>(x[axis]) : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType FindInfiniteGixel(const GixelView& gixels)
{
  for (vtkIdType gixel = 0; gixel < gixels.GetNumberOfGixels(); ++gixel)
  {
    double x[3];
    gixels.GetPoint(gixel, x);
    if ((std::isinf(x[0]) || std::isinf(x[1]) || std::isinf(x[2])) && gixels.IsUsed(gixel))
    {
      return gixel;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool CheckFinite(const GixelView& gixels, std::string& why)
{
  const vtkIdType gixel = FindInfiniteGixel(gixels);
  if (gixel < 0)
  {
    return true;
  }
  double x[3];
  gixels.GetPoint(gixel, x);
  std::ostringstream text;
  text << "Gixel (" << gixel % gixels.GetWidth() << ", " << gixel / gixels.GetWidth() << ") is at ("
       << x[0] << ", " << x[1] << ", " << x[2]
       << "); finite coordinates were expected, or NaN or a `Defined` of 0 where it is not used.";
  why = text.str();
  return false;
}

} // namespace bravais
