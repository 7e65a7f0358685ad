// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCResample_h
#define BCCResample_h

#include "vtkBravaisABINamespace.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractImageInterpolator;
class vtkAlgorithm;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

struct BCCPlacement;

/// The type in which samples of a scalar type are filtered: VTK_DOUBLE for double and 64-bit
/// integers, else VTK_FLOAT.
int GetArithmeticType(int scalarType);

/// The scalars of a whole image without the frequencies that the lattice cannot represent, in
/// their arithmetic type. Null if aborted.
vtkSmartPointer<vtkImageData> FilterLowPass(
  vtkAlgorithm* self, vtkImageData* image, const BCCPlacement& placement, double begin, double end);

/// Interpolates an image at all points of `output`, whose scalars are allocated. False if
/// aborted.
bool Interpolate(vtkAlgorithm* self, vtkImageData* image,
  vtkAbstractImageInterpolator* interpolator, const BCCPlacement& placement, vtkImageData* output,
  double begin, double end);

} // namespace bravais

#endif
