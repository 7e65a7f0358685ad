// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LayerSampler_h
#define LayerSampler_h

#include "vtkBravaisABINamespace.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractImageInterpolator;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

struct BCCPlacement;

/// Interpolates an image at the points of a BCC volume, a layer a call and from many threads.
class LayerSampler
{
public:
  virtual ~LayerSampler() = default;

  /// The values of layer k of the extent, components interleaved; valid until the same thread's
  /// next call.
  virtual const std::vector<double>& Sample(int k) = 0;
};

/// Whether an interpolator is a B-spline that wants coefficients, not samples.
bool NeedsCoefficients(vtkAbstractImageInterpolator* interpolator);

/// The coefficients of a whole image's scalars for such an interpolator, in float or double.
vtkSmartPointer<vtkImageData> ComputeCoefficients(
  vtkImageData* image, vtkAbstractImageInterpolator* interpolator, int outputScalarType);

/// A sampler of an image, or, if NeedsCoefficients, of its coefficients.
///
/// B-splines are evaluated here, since VTK's interpolators round the place between two samples to
/// 2^-16. Any other interpolator does its own work; meanwhile it holds the image.
std::unique_ptr<LayerSampler> MakeLayerSampler(vtkImageData* image,
  vtkAbstractImageInterpolator* interpolator, const BCCPlacement& placement, const int extent[6]);

} // namespace bravais

#endif
