// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCPrefilter_h
#define BCCPrefilter_h

#include "BCCKernel.h"

#include <optional>

namespace bravais
{

/// Ways from the samples of a function to the coefficients of a spline of a BCCKernel.
enum class BCCPrefilter : int
{
  None = 0,               ///< the samples are the coefficients
  QuasiInterpolation = 1, ///< local and of the kernel's approximation order
  Interpolation = 2,      ///< the spline passes through the samples; BCC4 and BCC8 only
  Projection = 3          ///< the spline is the nearest one, in L2, to the band-limited signal
};

/// The prefilter of that number, if there is one.
std::optional<BCCPrefilter> ToBCCPrefilter(int number);

/// "None", "QuasiInterpolation", "Interpolation" or "Projection".
const char* GetName(BCCPrefilter prefilter);

/// Whether a kernel has that prefilter. BCC7 and BCC12 have no Interpolation: the sum of
/// (-1)^coset times their shifts vanishes everywhere, so their splines cannot take all values at
/// the lattice points.
bool IsDefined(BCCKernel kernel, BCCPrefilter prefilter);

} // namespace bravais

#endif
