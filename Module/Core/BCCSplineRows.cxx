// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Dispatch over the instruction sets: BCCSplineLanes.inl is compiled once for each.

#include "BCCSplineRows.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "BCCSplineLanes.inl"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "BCCSplineLanes.inl"

namespace bravais
{

namespace
{
// Two of the widest vectors there are, 2048 bits. (HWY_MAX_BYTES is that of the compiler's own
// target.)
constexpr std::size_t MaximumLanes = 2 * 2048 / 8 / sizeof(float);
}

HWY_EXPORT(RowFloat);
HWY_EXPORT(RowDouble);
HWY_EXPORT(PointsFloat);
HWY_EXPORT(PointsDouble);

template <class R>
BCCPosition<R>::BCCPosition(double p)
{
  const double low = std::floor(p);
  const double odd = low - 2.0 * std::floor(0.5 * low);
  this->Even = static_cast<Integer>(low + odd);
  this->Sign = static_cast<R>(1.0 - 2.0 * odd);
  this->Offset = static_cast<R>((1.0 - 2.0 * odd) * (p - (low + odd)));
}

template <class R>
BCCPositions<R>::BCCPositions(std::size_t size)
  : Even(GetBCCResultSize(size), 0)
  , Sign(GetBCCResultSize(size), R(1))
  , Offset(GetBCCResultSize(size), R(0))
  , Size(size)
{
}

template <class R>
void BCCPositions<R>::Set(std::size_t n, const BCCPosition<R>& position)
{
  // The last position fills the rest of the arrays, where places are computed but not used.
  const std::size_t end = n + 1 == this->Size ? this->Even.size() : n + 1;
  for (; n < end; ++n)
  {
    this->Even[n] = position.Even;
    this->Sign[n] = position.Sign;
    this->Offset[n] = position.Offset;
  }
}

std::size_t GetBCCResultSize(std::size_t n)
{
  return n + MaximumLanes;
}

template <class R>
void EvaluateBCCRow(BCCKernel kernel, const BCCBlock<const R>& coefficients,
  const BCCPositions<R>& x, const BCCPosition<R>& y, const BCCPosition<R>& z,
  const BCCResults<R>& results)
{
  if constexpr (std::is_same_v<R, float>)
  {
    HWY_DYNAMIC_DISPATCH(RowFloat)(kernel, coefficients, x, y, z, results);
  }
  else
  {
    HWY_DYNAMIC_DISPATCH(RowDouble)(kernel, coefficients, x, y, z, results);
  }
}

template <class R>
void EvaluateBCCPoints(BCCKernel kernel, const BCCBlock<const R>& coefficients,
  const BCCPositions<R>& x, const BCCPositions<R>& y, const BCCPositions<R>& z,
  const BCCResults<R>& results)
{
  if constexpr (std::is_same_v<R, float>)
  {
    HWY_DYNAMIC_DISPATCH(PointsFloat)(kernel, coefficients, x, y, z, results);
  }
  else
  {
    HWY_DYNAMIC_DISPATCH(PointsDouble)(kernel, coefficients, x, y, z, results);
  }
}

#define BRAVAIS_INSTANTIATE(R)                                                                     \
  template struct BCCPosition<R>;                                                                  \
  template class BCCPositions<R>;                                                                  \
  template void EvaluateBCCRow(BCCKernel, const BCCBlock<const R>&, const BCCPositions<R>&,        \
    const BCCPosition<R>&, const BCCPosition<R>&, const BCCResults<R>&);                           \
  template void EvaluateBCCPoints(BCCKernel, const BCCBlock<const R>&, const BCCPositions<R>&,     \
    const BCCPositions<R>&, const BCCPositions<R>&, const BCCResults<R>&)

BRAVAIS_INSTANTIATE(float);
BRAVAIS_INSTANTIATE(double);

} // namespace bravais
