// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCSplineVolume_h
#define BCCSplineVolume_h

#include "BCCBlock.h"
#include "BCCKernel.h"
#include "BCCPrefilter.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// The coefficients of a whole volume, continued by the mirrors as far as stencils reach, so that
/// its spline can be evaluated anywhere in the box, from any number of threads.
class BCCSplineVolume
{
public:
  /// Computes the coefficients of an image that CheckBCCImage approves of, in parallel. The kernel
  /// has that prefilter.
  BCCSplineVolume(vtkImageData* image, BCCKernel kernel, BCCPrefilter prefilter);

  /// Whether these are that image's coefficients, and neither its scalars nor its extent changed.
  bool IsOf(vtkImageData* image, BCCKernel kernel, BCCPrefilter prefilter) const;

  /// Evaluates one component at a point of the box, in lattice coordinates.
  double Evaluate(const glm::dvec3& p, int component) const;

  /// Bytes that the coefficients of that image take.
  static int GetBytesPerPoint(vtkImageData* image);

  /// What a volume of that extent is continued to.
  static BCCExtent GetPaddedExtent(const int whole[6]);

private:
  template <class T>
  void Fill(const T* samples, int components);
  template <class R>
  double EvaluateIn(const BCCBlock<R>& plane, const glm::dvec3& p) const;

  BCCExtent Whole;
  BCCKernel Kernel;
  BCCPrefilter Prefilter;
  // Whose coefficients they are. The scalars themselves may be gone: times are never used twice.
  vtkMTimeType Time;

  std::vector<float> FloatMemory; // one of the two is in use
  std::vector<double> DoubleMemory;
  std::vector<BCCBlock<float>> FloatPlanes; // one a component
  std::vector<BCCBlock<double>> DoublePlanes;
};

} // namespace bravais

#endif
