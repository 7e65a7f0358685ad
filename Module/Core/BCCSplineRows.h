// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCSplineRows_h
#define BCCSplineRows_h

/// \file
/// The box-splines of the BCC lattice at many points at once: the work of BoxSpline.h by vector
/// instructions, the best set that the processor has (Google Highway). float coefficients are
/// evaluated in float, double ones in double. A point's value does not depend on which others are
/// evaluated with it.

#include "BCCBlock.h"
#include "BCCKernel.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace bravais
{

/// What is read to evaluate at a point (X, Y, Z): indices i from floor(X / 2) - BCCReachBelow.x to
/// floor(X / 2) + BCCReachAbove.x, j likewise, layers from floor(Z) - BCCReachBelow.z to floor(Z) +
/// BCCReachAbove.z.
inline constexpr glm::ivec3 BCCReachBelow(2, 2, 3);
inline constexpr glm::ivec3 BCCReachAbove(2, 2, 4);

/// A position along one axis, in lattice coordinates, split so that floats keep the fraction of
/// large coordinates: p = Even + Sign * Offset, Even an even Integer, which p must fit, and
/// 0 <= Offset <= 1.
template <class R>
struct BCCPosition
{
  using Integer = std::conditional_t<sizeof(R) == 8, std::int64_t, std::int32_t>;

  explicit BCCPosition(double p = 0.0);

  Integer Even;
  R Sign; ///< 1 or -1
  R Offset;
};

/// Positions of many points along one axis. The arrays are longer than the positions, so that whole
/// vectors can be read.
template <class R>
class BCCPositions
{
public:
  explicit BCCPositions(std::size_t size);

  void Set(std::size_t n, const BCCPosition<R>& position);
  std::size_t GetSize() const { return this->Size; }

  /// Says that the positions ascend, and are less than about 2 apart. Rows are then evaluated in a
  /// way that is faster and rounds differently, so that all pieces of a row should be told the
  /// same.
  void SetDense(bool dense) { this->Dense = dense; }
  bool IsDense() const { return this->Dense && this->Size > 0; }

  std::vector<typename BCCPosition<R>::Integer> Even;
  std::vector<R> Sign;
  std::vector<R> Offset;

private:
  std::size_t Size;
  bool Dense = false;
};

/// Where results go: arrays with room for GetBCCResultSize(n) numbers each. The gradient's three
/// components, along the lattice coordinates, are computed where X is not null.
template <class R>
struct BCCResults
{
  R* Value;
  R* X = nullptr;
  R* Y = nullptr;
  R* Z = nullptr;
};

/// The length of arrays for the results of n points: n, and room for the last vector.
std::size_t GetBCCResultSize(std::size_t n);

/// Evaluates at (x[n], y, z) for all n. `coefficients` has one component, covers what is read for
/// all points, and GetBCCResultSize(0) more values can be read, not used, beyond its end.
template <class R>
void EvaluateBCCRow(BCCKernel kernel, const BCCBlock<const R>& coefficients,
  const BCCPositions<R>& x, const BCCPosition<R>& y, const BCCPosition<R>& z,
  const BCCResults<R>& results);

/// Evaluates at the points (x[n], y[n], z[n]). Of float, the block holds fewer than 2^31 values.
template <class R>
void EvaluateBCCPoints(BCCKernel kernel, const BCCBlock<const R>& coefficients,
  const BCCPositions<R>& x, const BCCPositions<R>& y, const BCCPositions<R>& z,
  const BCCResults<R>& results);

} // namespace bravais

#endif
