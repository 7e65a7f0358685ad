// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCCoefficients_h
#define BCCCoefficients_h

/// \file
/// From the scalars of a BCC image to spline coefficients: what the filter, the interpolator and
/// the mapper share.

#include "BCCBlock.h"
#include "vtkBravaisABINamespace.h"

#include <atomic>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Whether the numbers are a kernel and a prefilter that go together; else `why` tells the reason.
bool CheckBCCSpline(int kernel, int prefilter, std::string& why);

/// VTK_DOUBLE for scalars of double or 64-bit integers, else VTK_FLOAT.
int GetBCCCoefficientType(int scalarType);

/// Whether the prefilter needs all samples to compute any coefficient.
bool NeedsWholeVolume(int prefilter);

/// An extent of the image's indices as Core has it.
BCCExtent ToBCCExtent(const int extent[6]);

/// Fills `coefficients`, an array of GetBCCCoefficientType with the scalars' components, with the
/// coefficients for `extent`. The image holds the samples of that extent and one more on each side,
/// within the whole extent, or the whole where the prefilter needs it. Progress goes to `self`
/// from `begin` to `end`; false if it was aborted. `self` may be nullptr. `finite`, if any, becomes
/// false where a coefficient is not.
bool ComputeBCCCoefficients(vtkAlgorithm* self, vtkImageData* image, const int whole[6], int kernel,
  int prefilter, vtkDataArray* coefficients, const int extent[6], double begin, double end,
  std::atomic<bool>* finite = nullptr);

/// Why coefficients are not finite: a sentence that tells how large the samples are, or nothing
/// where these are not finite themselves.
std::string ExplainBCCCoefficients(vtkDataArray* samples, vtkDataArray* coefficients);

} // namespace bravais

#endif
