// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GeometryImage_h
#define GeometryImage_h

/// \file
/// How a geometry image travels in VTK: a vtkImageData of w x h x 1 points, its gixels, that is
/// tagged GeometryImage, with the points' positions in a 3-component float or double point array
/// `Points`, and, where not all gixels are used, an unsigned char point array `Defined`.

#include "vtkBravaisABINamespace.h"
#include "vtkType.h"

#include <cmath>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

inline constexpr const char* GeometryImagePoints = "Points";
inline constexpr const char* GeometryImageDefined = "Defined";

/// Marks an image as a geometry image, and its array `Points`, where it has one, as its vectors.
void TagGeometryImage(vtkImageData* image);

/// Whether a data object is an image with that mark; false for nullptr.
bool IsGeometryImage(vtkDataObject* data);

/// Whether an image is tagged, has gixels in one slice, positions of all of them, and, if any,
/// a `Defined` of one unsigned char each. If not, `why` names the value and what was expected.
/// Positions are not looked at: see FindInfiniteGixel.
bool CheckGeometryImage(vtkImageData* image, std::string& why);

/// Reads the gixels of an image that CheckGeometryImage has passed, in memory order: x fastest. It
/// holds pointers into the image's arrays, and may be used by several threads.
class GixelView
{
public:
  explicit GixelView(vtkImageData* image);

  vtkIdType GetWidth() const { return this->Width; }
  vtkIdType GetHeight() const { return this->Height; }
  vtkIdType GetNumberOfGixels() const { return this->Width * this->Height; }

  /// The positions, three numbers a gixel: one of these two is not nullptr.
  const float* GetFloats() const { return this->Floats; }
  const double* GetDoubles() const { return this->Doubles; }

  /// One number a gixel, 0 for those that are not used; nullptr if there is no such array.
  const unsigned char* GetDefined() const { return this->Defined; }

  void GetPoint(vtkIdType gixel, double x[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType at = 3 * gixel + axis;
      x[axis] = this->Floats ? static_cast<double>(this->Floats[at]) : this->Doubles[at];
    }
  }

  /// Whether a gixel is part of the surface: defined, and no coordinate is NaN.
  bool IsUsed(vtkIdType gixel) const
  {
    if (this->Defined && !this->Defined[gixel])
    {
      return false;
    }
    double x[3];
    this->GetPoint(gixel, x);
    return !(std::isnan(x[0]) || std::isnan(x[1]) || std::isnan(x[2]));
  }

private:
  vtkIdType Width;
  vtkIdType Height;
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  const unsigned char* Defined = nullptr;
};

/// A row of positions as floats, 3 a gixel; NaN where it is not used.
void GetRow(const GixelView& gixels, vtkIdType row, float* points);

/// The first used gixel with an infinite coordinate, or -1.
vtkIdType FindInfiniteGixel(const GixelView& gixels);

/// Whether no used gixel has an infinite coordinate; else `why` names the first.
bool CheckFinite(const GixelView& gixels, std::string& why);

} // namespace bravais

#endif
