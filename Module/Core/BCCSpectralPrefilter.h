// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCSpectralPrefilter_h
#define BCCSpectralPrefilter_h

#include "BCCBlock.h"
#include "BCCPrefilter.h"

#include <functional>

namespace bravais
{

/// Calls a function on parts of begin .. end - 1, in any order and from any threads, and returns
/// when all are done. E.g. with vtkSMPTools:
///
///     [](std::int64_t begin, std::int64_t end, const auto& body)
///     { vtkSMPTools::For(begin, end, [&](vtkIdType b, vtkIdType e) { body(b, e); }); }
using ParallelFor = std::function<void(std::int64_t begin, std::int64_t end,
  const std::function<void(std::int64_t, std::int64_t)>& body)>;

/// Takes the part that is done, 0 to 1, and tells whether to go on. Called on the caller's thread.
using ProgressFunction = std::function<bool(double)>;

/// Interpolation and Projection: samples to coefficients, in place, by Fourier transforms of the
/// whole volume with its mirrored continuation. See BCCResponse for what they compute.
///
/// As the mirrors make all transforms real and even, the spectrum has as many numbers as there are
/// samples: it is kept in their place, and the only other memory is a few lines a thread. Lines
/// are computed in double, in O(n log n) for any length, and rounded to R (float or double)
/// between the passes: along x and y, along z with the filter, back along y and x. What a line's
/// result is does not depend on how the work is parted.
///
/// A NaN or an infinity anywhere makes all values of its component NaN.
///
/// False, with nothing changed, if the kernel has no such prefilter, the prefilter is not one of
/// these two, the extent (the whole one) is empty, or has fewer than two layers. False as well,
/// with the volume's values without meaning, if `progress` stopped the work.
template <class R>
bool ApplySpectralPrefilter(BCCKernel kernel, BCCPrefilter prefilter, const BCCBlock<R>& volume,
  const ParallelFor& parallelFor = {}, const ProgressFunction& progress = {});

} // namespace bravais

#endif
