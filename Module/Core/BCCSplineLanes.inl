// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The loops of BCCSplineRows, for one instruction set: included by BCCSplineRows.cxx once for each,
// therefore no guard. Each lane of a vector does what BoxSpline.h does for one point.

#include "BCCSplineRows.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bravais
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

#include "BCC4Polynomial.inl"
#include "BCC7Polynomial.inl"
#include "BCC8Polynomial.inl"

/// A vector as a number type, for the polynomials.
template <class R>
struct Lanes
{
  using D = hn::ScalableTag<R>;
  using V = hn::Vec<D>;

  Lanes() = default;
  HWY_INLINE HWY_ATTR Lanes(V v) // NOLINT: implicit as between numbers
    : Vector(v)
  {
  }
  HWY_INLINE HWY_ATTR explicit Lanes(double number)
    : Vector(hn::Set(D(), static_cast<R>(number)))
  {
  }

  V Vector;
};

template <class R>
HWY_INLINE HWY_ATTR Lanes<R> operator+(Lanes<R> a, Lanes<R> b)
{
  return hn::Add(a.Vector, b.Vector);
}

template <class R>
HWY_INLINE HWY_ATTR Lanes<R> operator-(Lanes<R> a, Lanes<R> b)
{
  return hn::Sub(a.Vector, b.Vector);
}

template <class R>
HWY_INLINE HWY_ATTR Lanes<R> operator*(Lanes<R> a, Lanes<R> b)
{
  return hn::Mul(a.Vector, b.Vector);
}

/// Integers of a vector's width, for places in memory.
template <class R>
using Places = hn::Vec<hn::RebindToSigned<hn::ScalableTag<R>>>;

/// One axis' part of the points of a vector.
template <class R>
struct LanesPosition
{
  Places<R> Even;
  Lanes<R> Sign;
  Lanes<R> Offset;

  HWY_INLINE HWY_ATTR void Load(const BCCPositions<R>& from, std::size_t n)
  {
    const hn::ScalableTag<R> d;
    const hn::RebindToSigned<decltype(d)> di;
    this->Even = hn::LoadU(di, from.Even.data() + n);
    this->Sign = hn::LoadU(d, from.Sign.data() + n);
    this->Offset = hn::LoadU(d, from.Offset.data() + n);
  }

  HWY_INLINE HWY_ATTR void Fill(const BCCPosition<R>& position)
  {
    const hn::ScalableTag<R> d;
    const hn::RebindToSigned<decltype(d)> di;
    this->Even = hn::Set(di, position.Even);
    this->Sign = hn::Set(d, position.Sign);
    this->Offset = hn::Set(d, position.Offset);
  }

  /// Moves the positions by an even number.
  HWY_INLINE HWY_ATTR void Subtract(typename BCCPosition<R>::Integer number)
  {
    const hn::RebindToSigned<hn::ScalableTag<R>> di;
    this->Even = hn::Sub(this->Even, hn::Set(di, number));
  }
};

/// What a place of memory is worth, and how far apart rows and layers are.
template <class R>
struct Memory
{
  const R* Origin; ///< of index (0, 0, 0), or of (0, j, k) where rows are evaluated
  typename BCCPosition<R>::Integer Row;
  typename BCCPosition<R>::Integer Layer;

  explicit Memory(const BCCBlock<const R>& block)
    : Origin(block.Data - block.Extent[0] - block.RowStride * block.Extent[2] -
        block.LayerStride * block.Extent[4])
    , Row(static_cast<decltype(Row)>(block.RowStride))
    , Layer(static_cast<decltype(Layer)>(block.LayerStride))
  {
  }

  HWY_INLINE HWY_ATTR Lanes<R> operator()(Places<R> place) const
  {
    return hn::GatherIndex(hn::ScalableTag<R>(), this->Origin, place);
  }
};

template <class R>
struct LanesResults
{
  Lanes<R> Value, X, Y, Z;

  template <bool Gradient>
  HWY_INLINE HWY_ATTR void Store(const BCCResults<R>& to, std::size_t n) const
  {
    const hn::ScalableTag<R> d;
    hn::StoreU(this->Value.Vector, d, to.Value + n);
    if constexpr (Gradient)
    {
      hn::StoreU(this->X.Vector, d, to.X + n);
      hn::StoreU(this->Y.Vector, d, to.Y + n);
      hn::StoreU(this->Z.Vector, d, to.Z + n);
    }
  }
};

/// Puts the larger of two offsets first, its axis' step with it; tells where it had to.
template <class R, class Mask = hn::Mask<hn::ScalableTag<R>>>
Mask SortPair(Lanes<R>& a, Lanes<R>& b, Places<R>& stepA, Places<R>& stepB)
{
  const hn::ScalableTag<R> d;
  const hn::RebindToSigned<decltype(d)> di;
  const Mask swap = hn::Gt(b.Vector, a.Vector);
  const auto larger = hn::Max(a.Vector, b.Vector);
  b = hn::Min(a.Vector, b.Vector);
  a = larger;
  const auto first = hn::BitCast(d, stepA);
  const auto second = hn::BitCast(d, stepB);
  stepA = hn::BitCast(di, hn::IfThenElse(swap, second, first));
  stepB = hn::BitCast(di, hn::IfThenElse(swap, first, second));
  return swap;
}

template <class R, class Mask>
void SwapWhere(Mask swap, Lanes<R>& a, Lanes<R>& b)
{
  const auto first = hn::IfThenElse(swap, b.Vector, a.Vector);
  b = hn::IfThenElse(swap, a.Vector, b.Vector);
  a = first;
}

/// bcc4, bcc7 and bcc8, by the frame of BoxSpline.h; a sorting network stands for its permutation.
template <BCCKernel Kernel, bool Gradient, class R>
LanesResults<R> EvaluateTetrahedron(const Memory<R>& memory, const LanesPosition<R>& px,
  const LanesPosition<R>& py, const LanesPosition<R>& pz)
{
  const hn::ScalableTag<R> d;
  const hn::RebindToSigned<decltype(d)> di;
  constexpr int SignBit = 8 * sizeof(R) - 1;
  const auto row = hn::Set(di, memory.Row);
  const auto layer = hn::Set(di, memory.Layer);
  const auto one = hn::Set(di, 1);
  // -1 where the axis is reflected, else 0.
  const auto rx = hn::ShiftRight<SignBit>(hn::BitCast(di, px.Sign.Vector));
  const auto ry = hn::ShiftRight<SignBit>(hn::BitCast(di, py.Sign.Vector));
  const auto rz = hn::ShiftRight<SignBit>(hn::BitCast(di, pz.Sign.Vector));
  const auto stepLayer = hn::Sub(hn::Xor(layer, rz), rz); // layer times the sign
  const auto even =
    hn::Add(hn::Add(hn::ShiftRight<1>(px.Even), hn::Mul(hn::ShiftRight<1>(py.Even), row)),
      hn::Mul(pz.Even, layer));
  const auto odd = hn::Add(hn::Add(even, rx), hn::Add(hn::And(ry, hn::Neg(row)), stepLayer));
  Places<R> s0 = hn::Or(rx, one);
  Places<R> s1 = hn::Sub(hn::Xor(row, ry), ry);
  Places<R> s2 = hn::Add(stepLayer, stepLayer);
  Lanes<R> x = px.Offset;
  Lanes<R> y = py.Offset;
  Lanes<R> z = pz.Offset;
  const auto swap1 = SortPair<R>(x, y, s0, s1);
  const auto swap2 = SortPair<R>(y, z, s1, s2);
  const auto swap3 = SortPair<R>(x, y, s0, s1);

  LanesResults<R> result;
  if constexpr (Kernel == BCCKernel::BCC4)
  {
    Lanes<R> c[4];
    BCC4Fetch(even, odd, s0, s1, s2, memory, c);
    result.Value = BCC4Polynomial(x, y, z, c, result.X, result.Y, result.Z);
  }
  else if constexpr (Kernel == BCCKernel::BCC7)
  {
    Lanes<R> c[30];
    BCC7Fetch(even, odd, s0, s1, s2, memory, c);
    result.Value = BCC7Polynomial(x, y, z, c, result.X, result.Y, result.Z);
  }
  else
  {
    Lanes<R> c[32];
    BCC8Fetch(even, odd, s0, s1, s2, memory, c);
    result.Value = BCC8Polynomial(x, y, z, c, result.X, result.Y, result.Z);
  }
  if constexpr (Gradient)
  {
    SwapWhere(swap3, result.X, result.Y);
    SwapWhere(swap2, result.Y, result.Z);
    SwapWhere(swap1, result.X, result.Y);
    result.X = result.X * px.Sign;
    result.Y = result.Y * py.Sign;
    result.Z = result.Z * pz.Sign;
  }
  return result;
}

#include "BCCSplineCubic.inl"
#include "BCCSplinePieces.inl"

template <bool Gradient, class R>
LanesResults<R> EvaluateAny(BCCKernel kernel, const Memory<R>& memory, const LanesPosition<R>& x,
  const LanesPosition<R>& y, const LanesPosition<R>& z)
{
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return EvaluateTetrahedron<BCCKernel::BCC4, Gradient>(memory, x, y, z);
    case BCCKernel::BCC7:
      return EvaluateTetrahedron<BCCKernel::BCC7, Gradient>(memory, x, y, z);
    case BCCKernel::BCC8:
      return EvaluateTetrahedron<BCCKernel::BCC8, Gradient>(memory, x, y, z);
    default:
      return EvaluateCubic<Gradient>(memory, x, y, z);
  }
}

template <bool Gradient, class R>
void Row(BCCKernel kernel, const BCCBlock<const R>& coefficients, const BCCPositions<R>& x,
  const BCCPosition<R>& y, const BCCPosition<R>& z, const BCCResults<R>& results)
{
  if (kernel == BCCKernel::BCC12)
  {
    EvaluateCubicRow<Gradient>(coefficients, x, y, z, results);
    return;
  }
  if constexpr (!Gradient)
  {
    if (x.IsDense() && kernel == BCCKernel::BCC7)
    {
      EvaluatePiecesRow<BCCKernel::BCC7>(coefficients, x, y, z, results);
      return;
    }
    if (x.IsDense() && kernel == BCCKernel::BCC8)
    {
      EvaluatePiecesRow<BCCKernel::BCC8>(coefficients, x, y, z, results);
      return;
    }
  }
  // Along a row only x varies: the rest of the place is a pointer, and has 64 bits.
  Memory<R> memory(coefficients);
  memory.Origin += coefficients.RowStride * (y.Even / 2) + coefficients.LayerStride * z.Even;
  LanesPosition<R> px;
  LanesPosition<R> py;
  LanesPosition<R> pz;
  py.Fill(y);
  pz.Fill(z);
  py.Even = hn::Sub(py.Even, py.Even);
  pz.Even = py.Even;
  for (std::size_t n = 0; n < x.GetSize(); n += hn::Lanes(hn::ScalableTag<R>()))
  {
    px.Load(x, n);
    EvaluateAny<Gradient>(kernel, memory, px, py, pz).template Store<Gradient>(results, n);
  }
}

template <bool Gradient, class R>
void Points(BCCKernel kernel, const BCCBlock<const R>& coefficients, const BCCPositions<R>& x,
  const BCCPositions<R>& y, const BCCPositions<R>& z, const BCCResults<R>& results)
{
  // Places are counted from the block's first even layer: from index 0, however far away, they
  // could have more bits than an Integer.
  const BCCExtent& extent = coefficients.Extent;
  const int firstLayer = extent[4] & ~1;
  Memory<R> memory(coefficients);
  memory.Origin +=
    extent[0] + coefficients.RowStride * extent[2] + coefficients.LayerStride * firstLayer;
  LanesPosition<R> px;
  LanesPosition<R> py;
  LanesPosition<R> pz;
  for (std::size_t n = 0; n < x.GetSize(); n += hn::Lanes(hn::ScalableTag<R>()))
  {
    px.Load(x, n);
    py.Load(y, n);
    pz.Load(z, n);
    px.Subtract(2 * extent[0]);
    py.Subtract(2 * extent[2]);
    pz.Subtract(firstLayer);
    EvaluateAny<Gradient>(kernel, memory, px, py, pz).template Store<Gradient>(results, n);
  }
}

#define BRAVAIS_DISPATCHED(R, Name)                                                                \
  void Row##Name(BCCKernel kernel, const BCCBlock<const R>& coefficients,                          \
    const BCCPositions<R>& x, const BCCPosition<R>& y, const BCCPosition<R>& z,                    \
    const BCCResults<R>& results)                                                                  \
  {                                                                                                \
    results.X ? Row<true>(kernel, coefficients, x, y, z, results)                                  \
              : Row<false>(kernel, coefficients, x, y, z, results);                                \
  }                                                                                                \
  void Points##Name(BCCKernel kernel, const BCCBlock<const R>& coefficients,                       \
    const BCCPositions<R>& x, const BCCPositions<R>& y, const BCCPositions<R>& z,                  \
    const BCCResults<R>& results)                                                                  \
  {                                                                                                \
    results.X ? Points<true>(kernel, coefficients, x, y, z, results)                               \
              : Points<false>(kernel, coefficients, x, y, z, results);                             \
  }

BRAVAIS_DISPATCHED(float, Float)
BRAVAIS_DISPATCHED(double, Double)
#undef BRAVAIS_DISPATCHED

} // namespace HWY_NAMESPACE
} // namespace bravais
HWY_AFTER_NAMESPACE();
