// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCQuasiInterpolation_h
#define BCCQuasiInterpolation_h

/// \file
/// The quasi-interpolation prefilter of the BCC kernels: from samples f to coefficients
///
///     c(j) = q0 f(j) + q1 (sum of f over the 8 neighbours of j in S1),
///
/// with q0 + 8 q1 = 1, so that the spline with the coefficients c reproduces cubics (BCC7, BCC8,
/// BCC12) or linear functions (BCC4, where q1 = 0). Beyond the volume's box the samples are
/// continued by the whole-sample mirror at X = 2 i0 and 2 i1 + 1, Y likewise, Z = k0 and k1, with
/// i0
/// .. k1 the whole extent, which may start anywhere.
///
/// A piece of a volume is computed from a piece of the samples that is one layer wider on every
/// side, as far as the whole reaches. Each coefficient is the same sum in the same order whatever
/// the piece, so pieces agree with the whole bit for bit, and a caller may cut the work among
/// threads, or make coefficients layer by layer, as it likes:
///
///     const BCCExtent whole = { 0, nx - 1, 0, ny - 1, 0, nk - 1 };
///     BCCBlock<const float> samples(input, whole);
///     BCCBlock<float> layer(output, { 0, nx - 1, 0, ny - 1, k, k });
///     bool done = QuasiInterpolate(BCCKernel::BCC7, whole, samples, layer);

#include "BCCBlock.h"
#include "BCCKernel.h"

#include <type_traits>

namespace bravais
{

/// The weights of the centre and of each neighbour in S1.
struct BCCQuasiInterpolant
{
  double Center;
  double Neighbor;
};
BCCQuasiInterpolant GetQuasiInterpolant(BCCKernel kernel);

/// The type in which coefficients of samples of type T are computed and kept: double for double
/// and 64-bit integers, else float.
template <class T>
using BCCCoefficient =
  std::conditional_t<std::is_same_v<T, double> || (std::is_integral_v<T> && sizeof(T) == 8), double,
    float>;

/// Fills `coefficients`, all of its extent, from `samples`, which must cover that extent grown by
/// one on every side and clipped to `whole`. Any component count; T is any arithmetic type but
/// bool and long double, R is BCCCoefficient<T> or double. False, with nothing written, if the
/// samples do not cover what is needed, an extent is empty or beyond the whole, the component
/// counts differ, or the whole has fewer than two layers (of which none has all its neighbours).
template <class T, class R>
bool QuasiInterpolate(BCCKernel kernel, const BCCExtent& whole, const BCCBlock<const T>& samples,
  const BCCBlock<R>& coefficients);

} // namespace bravais

#endif
