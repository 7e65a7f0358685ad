// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// bcc12 in vectors, a part of BCCSplineLanes.inl: the separable kernel, at any points, and along
// rows, where the sums over y and z are shared.

/// Cubic B-spline weights of four coefficients, and their derivatives, half of them since the
/// cosets' spacing is 2.
template <class T>
void CubicLaneWeights(T t, T* w, T* d)
{
  const T s = T(1.0) - t;
  w[0] = T(1.0 / 6.0) * (s * s * s);
  w[1] = T(1.0 / 6.0) * (T(4.0) + t * t * (T(3.0) * t - T(6.0)));
  w[2] = T(1.0 / 6.0) * (T(4.0) + s * s * (T(3.0) * s - T(6.0)));
  w[3] = T(1.0 / 6.0) * (t * t * t);
  d[0] = T(-0.25) * (s * s);
  d[1] = T(0.25) * (t * (T(3.0) * t - T(4.0)));
  d[2] = T(-0.25) * (s * (T(3.0) * s - T(4.0)));
  d[3] = T(0.25) * (t * t);
}

/// Along one axis: the index of the first of the four coefficients, and the fraction, for the coset
/// of parity 0 or 1. Even + Sign Offset is 2 (first + 1 + t) + parity.
template <class R>
void SplitCubic(const LanesPosition<R>& p, int parity, Places<R>& first, Lanes<R>& t)
{
  const hn::ScalableTag<R> d;
  const hn::RebindToSigned<decltype(d)> di;
  constexpr int SignBit = 8 * sizeof(R) - 1;
  const Lanes<R> half = Lanes<R>(0.5) * (p.Sign * p.Offset);
  const auto index = hn::ShiftRight<1>(p.Even);
  if (parity == 1)
  {
    first = hn::Sub(index, hn::Set(di, 2));
    t = Lanes<R>(0.5) + half;
    return;
  }
  const auto reflected = hn::ShiftRight<SignBit>(hn::BitCast(di, p.Sign.Vector));
  first = hn::Add(hn::Sub(index, hn::Set(di, 1)), reflected);
  // Not IfNegativeThenElse, which Highway 1.0.3 gets wrong for SSSE3.
  const auto negative = hn::Lt(p.Sign.Vector, hn::Zero(d));
  t = half + Lanes<R>(hn::IfThenElseZero(negative, hn::Set(d, R(1))));
}

template <bool Gradient, class R>
LanesResults<R> EvaluateCubic(const Memory<R>& memory, const LanesPosition<R>& x,
  const LanesPosition<R>& y, const LanesPosition<R>& z)
{
  using L = Lanes<R>;
  const hn::RebindToSigned<hn::ScalableTag<R>> di;
  const auto row = hn::Set(di, memory.Row);
  const auto layer = hn::Set(di, memory.Layer);
  LanesResults<R> sum = { L(0.0), L(0.0), L(0.0), L(0.0) };
  for (int parity = 0; parity < 2; ++parity)
  {
    Places<R> i;
    Places<R> j;
    Places<R> k;
    L t[3];
    L w[3][4];
    L d[3][4];
    SplitCubic(x, parity, i, t[0]);
    SplitCubic(y, parity, j, t[1]);
    SplitCubic(z, parity, k, t[2]);
    for (int n = 0; n < 3; ++n)
    {
      CubicLaneWeights(t[n], w[n], d[n]);
    }
    k = hn::Add(hn::Add(k, k), hn::Set(di, parity));
    const auto base = hn::Add(i, hn::Add(hn::Mul(j, row), hn::Mul(k, layer)));
    for (int c = 0; c < 4; ++c)
    {
      for (int b = 0; b < 4; ++b)
      {
        const auto place = hn::Add(base, hn::Set(di, b * memory.Row + 2 * c * memory.Layer));
        L line(0.0);
        L slope(0.0);
        for (int a = 0; a < 4; ++a)
        {
          const L f = memory(hn::Add(place, hn::Set(di, a)));
          line = line + w[0][a] * f;
          slope = slope + d[0][a] * f;
        }
        sum.Value = sum.Value + w[1][b] * w[2][c] * line;
        if constexpr (Gradient)
        {
          sum.X = sum.X + w[1][b] * w[2][c] * slope;
          sum.Y = sum.Y + d[1][b] * w[2][c] * line;
          sum.Z = sum.Z + w[1][b] * d[2][c] * line;
        }
      }
    }
  }
  return { L(0.5) * sum.Value, L(0.5) * sum.X, L(0.5) * sum.Y, L(0.5) * sum.Z };
}

/// Sums 16 rows of coefficients into one line for the value, one for the derivative along y and one
/// along z, from index `begin` to `end`.
template <bool Gradient, class R>
void SumCubicLines(const Memory<R>& memory, const Lanes<R>* wy, const Lanes<R>* dy,
  const Lanes<R>* wz, const Lanes<R>* dz, std::ptrdiff_t begin, std::ptrdiff_t end, R* const* lines)
{
  using L = Lanes<R>;
  const hn::ScalableTag<R> d;
  const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  for (std::ptrdiff_t n = begin; n < end; n += step)
  {
    L value(0.0);
    L alongY(0.0);
    L alongZ(0.0);
    for (int c = 0; c < 4; ++c)
    {
      L layer(0.0);
      L layerY(0.0);
      for (int b = 0; b < 4; ++b)
      {
        const L f = hn::LoadU(d,
          memory.Origin + n + static_cast<std::ptrdiff_t>(b) * memory.Row +
            static_cast<std::ptrdiff_t>(2 * c) * memory.Layer);
        layer = layer + wy[b] * f;
        if constexpr (Gradient)
        {
          layerY = layerY + dy[b] * f;
        }
      }
      value = value + wz[c] * layer;
      if constexpr (Gradient)
      {
        alongY = alongY + wz[c] * layerY;
        alongZ = alongZ + dz[c] * layer;
      }
    }
    hn::StoreU(value.Vector, d, lines[0] + (n - begin));
    if constexpr (Gradient)
    {
      hn::StoreU(alongY.Vector, d, lines[1] + (n - begin));
      hn::StoreU(alongZ.Vector, d, lines[2] + (n - begin));
    }
  }
}

template <bool Gradient, class R>
void EvaluateCubicRow(const BCCBlock<const R>& coefficients, const BCCPositions<R>& x,
  const BCCPosition<R>& y, const BCCPosition<R>& z, const BCCResults<R>& results)
{
  using L = Lanes<R>;
  const hn::ScalableTag<R> d;
  const std::ptrdiff_t begin = coefficients.Extent[0];
  const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(coefficients.Extent[1]) + 1;
  const std::size_t length = static_cast<std::size_t>(end - begin) + hn::Lanes(d);
  std::vector<R> buffer(6 * length);
  R* lines[2][3];
  LanesPosition<R> py;
  LanesPosition<R> pz;
  py.Fill(y);
  pz.Fill(z);
  for (int parity = 0; parity < 2; ++parity)
  {
    for (int n = 0; n < 3; ++n)
    {
      lines[parity][n] = buffer.data() + static_cast<std::size_t>(3 * parity + n) * length;
    }
    Places<R> j;
    Places<R> k;
    L t;
    L wy[4];
    L dy[4];
    L wz[4];
    L dz[4];
    SplitCubic(py, parity, j, t);
    CubicLaneWeights(t, wy, dy);
    SplitCubic(pz, parity, k, t);
    CubicLaneWeights(t, wz, dz);
    Memory<R> memory(coefficients);
    memory.Origin += coefficients.RowStride * static_cast<std::int64_t>(hn::GetLane(j)) +
      coefficients.LayerStride * (2 * static_cast<std::int64_t>(hn::GetLane(k)) + parity);
    SumCubicLines<Gradient>(memory, wy, dy, wz, dz, begin, end, lines[parity]);
  }
  LanesPosition<R> px;
  for (std::size_t n = 0; n < x.GetSize(); n += hn::Lanes(d))
  {
    px.Load(x, n);
    LanesResults<R> sum = { L(0.0), L(0.0), L(0.0), L(0.0) };
    for (int parity = 0; parity < 2; ++parity)
    {
      Places<R> i;
      L t;
      L w[4];
      L slope[4];
      SplitCubic(px, parity, i, t);
      CubicLaneWeights(t, w, slope);
      for (int a = 0; a < 4; ++a)
      {
        const hn::RebindToSigned<decltype(d)> di;
        const auto place =
          hn::Add(i, hn::Set(di, static_cast<typename BCCPosition<R>::Integer>(a - begin)));
        const L f = hn::GatherIndex(d, lines[parity][0], place);
        sum.Value = sum.Value + w[a] * f;
        if constexpr (Gradient)
        {
          sum.X = sum.X + slope[a] * f;
          sum.Y = sum.Y + w[a] * L(hn::GatherIndex(d, lines[parity][1], place));
          sum.Z = sum.Z + w[a] * L(hn::GatherIndex(d, lines[parity][2], place));
        }
      }
    }
    const LanesResults<R> half = { L(0.5) * sum.Value, L(0.5) * sum.X, L(0.5) * sum.Y,
      L(0.5) * sum.Z };
    half.template Store<Gradient>(results, n);
  }
}
