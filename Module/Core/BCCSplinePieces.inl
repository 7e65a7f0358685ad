// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// bcc7 and bcc8 along dense rows, a part of BCCSplineLanes.inl. Along a row y and z are constant,
// and the spline is a polynomial in the offset t from an even lattice coordinate, left or right of
// it, one for each rank of t among the offsets a >= b of the other two axes: t < b, b < t < a, a <
// t. Their coefficients are sums over the stencil with weights that are the same all along the row,
// so they are made for a vector of neighbouring lattice points at a time, from memory that is
// contiguous. What is left for a point is to look up one polynomial.

/// A kernel's numbers, as the templates below want them.
template <BCCKernel Kernel>
struct PieceTraits;

template <>
struct PieceTraits<BCCKernel::BCC7>
{
  static constexpr int Degree = 4;
  static constexpr int Taps = 30;
  static constexpr int Scale = BCC7Scale;
  static constexpr auto& Stencil = BCC7Stencil;
  static constexpr auto& Monomials = BCC7Monomials;
};

template <>
struct PieceTraits<BCCKernel::BCC8>
{
  static constexpr int Degree = 5;
  static constexpr int Taps = 32;
  static constexpr int Scale = BCC8Scale;
  static constexpr auto& Stencil = BCC8Stencil;
  static constexpr auto& Monomials = BCC8Monomials;
};

/// A kernel's tables, with the taps side by side as vectors read them. There is room for 32.
template <BCCKernel Kernel, class R>
struct PieceTables
{
  using Traits = PieceTraits<Kernel>;
  static constexpr int Terms = Traits::Degree + 1;
  static constexpr int Room = 32;

  alignas(64) R Factor[Terms][Terms][Terms][Room] = {}; ///< by the powers of x, y and z
  alignas(64) std::int32_t Stencil[3][Room] = {};
  alignas(64) std::int32_t Odd[Room] = {};

  static const PieceTables& Get()
  {
    static const PieceTables tables;
    return tables;
  }

private:
  PieceTables()
  {
    for (const auto& m : Traits::Monomials)
    {
      this->Factor[m[1]][m[2]][m[3]][m[0]] = static_cast<R>(m[4]) / R(Traits::Scale);
    }
    for (int tap = 0; tap < Traits::Taps; ++tap)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Stencil[axis][tap] = Traits::Stencil[tap][axis];
      }
      this->Odd[tap] = Traits::Stencil[tap][0] & 1;
    }
  }
};

/// The weights of a row: of the coefficient of t^n, from each tap of the stencil, for each rank.
template <BCCKernel Kernel, class R>
struct PieceWeights
{
  using Tables = PieceTables<Kernel, R>;
  static constexpr int Terms = Tables::Terms;

  alignas(64) R W[3][Terms][Tables::Room] = {};

  HWY_ATTR PieceWeights(const Tables& tables, R a, R b)
  {
    R pa[Terms] = { R(1) };
    R pb[Terms] = { R(1) };
    for (int n = 1; n < Terms; ++n)
    {
      pa[n] = pa[n - 1] * a;
      pb[n] = pb[n - 1] * b;
    }
    for (int m = 0; m < Terms; ++m)
    {
      for (int n = 0; m + n < Terms; ++n)
      {
        // The pieces join with two continuous derivatives, so beyond the first only the highest
        // terms are needed.
        const R product = pa[m] * pb[n];
        for (int t = 0; m + n + t < Terms; ++t)
        {
          this->Add(this->W[2][t], product, tables.Factor[m][n][t]);
          if (t >= 3)
          {
            this->Add(this->W[1][t], product, tables.Factor[m][t][n]);
            this->Add(this->W[0][t], product, tables.Factor[t][m][n]);
          }
        }
      }
    }
  }

private:
  static HWY_INLINE HWY_ATTR void Add(R* sum, R product, const R* factor)
  {
    const hn::ScalableTag<R> d;
    const auto scale = hn::Set(d, product);
    for (std::size_t tap = 0; tap < Tables::Room; tap += hn::Lanes(d))
    {
      hn::Store(hn::MulAdd(scale, hn::Load(d, factor + tap), hn::Load(d, sum + tap)), d, sum + tap);
    }
  }
};

/// Sums the terms First .. Degree of a piece over the stencil, for two vectors of lattice points.
template <int First, class Traits, class R, class Weights>
HWY_INLINE HWY_ATTR void SumPiece(
  const R* at, const std::int32_t* places, const Weights& weights, Lanes<R> (*sum)[2])
{
  const hn::ScalableTag<R> d;
  for (int n = First; n <= Traits::Degree; ++n)
  {
    sum[n][0] = sum[n][1] = Lanes<R>(0.0);
  }
  for (int tap = 0; tap < Traits::Taps; ++tap)
  {
    const Lanes<R> c0 = hn::LoadU(d, at + places[tap]);
    const Lanes<R> c1 = hn::LoadU(d, at + places[tap] + hn::Lanes(d));
    for (int n = First; n <= Traits::Degree; ++n)
    {
      const Lanes<R> w = hn::Set(d, weights[n][tap]);
      sum[n][0] = sum[n][0] + w * c0;
      sum[n][1] = sum[n][1] + w * c1;
    }
  }
}

/// Makes the terms below the third of the piece behind the knot, from those before it and the
/// highest terms of both: their difference is (t - knot)^3 times a polynomial.
template <int Degree, class R>
HWY_INLINE HWY_ATTR void JoinPieces(R knot, const Lanes<R> (*before)[2], Lanes<R> (*behind)[2])
{
  using L = Lanes<R>;
  const L k(static_cast<double>(knot));
  const L k2 = k * k;
  const L k3 = k2 * k;
  for (int u = 0; u < 2; ++u)
  {
    L d3 = behind[3][u] - before[3][u];
    L d4 = behind[4][u] - before[4][u];
    L c2 = before[2][u];
    L c1 = before[1][u];
    L c0 = before[0][u];
    if constexpr (Degree == 5)
    {
      const L d5 = behind[5][u] - before[5][u];
      d3 = d3 + L(4.0) * k * d4 + L(10.0) * k2 * d5;
      d4 = d4 + L(5.0) * k * d5;
      c2 = c2 - L(10.0) * k3 * d5;
      c1 = c1 + L(5.0) * k2 * k2 * d5;
      c0 = c0 - k2 * k3 * d5;
    }
    else
    {
      d3 = d3 + L(4.0) * k * d4;
    }
    behind[2][u] = c2 - L(3.0) * k * d3 + L(6.0) * k2 * d4;
    behind[1][u] = c1 + L(3.0) * k2 * d3 - L(4.0) * k3 * d4;
    behind[0][u] = c0 - k3 * d3 + k2 * k2 * d4;
  }
}

/// Places in memory of the taps, from that of the even lattice point, where t takes the axis `rank`
/// of the reference tetrahedron and the other two follow in their order.
template <class Tables>
void FindTaps(const Tables& tables, int rank, const int sign[3], bool yFirst, int row, int layer,
  std::int32_t* places)
{
  const std::int32_t* larger = tables.Stencil[rank == 0 ? 1 : 0];
  const std::int32_t* smaller = tables.Stencil[rank == 2 ? 1 : 2];
  const std::int32_t* alongX = tables.Stencil[rank];
  const std::int32_t* alongY = yFirst ? larger : smaller;
  const std::int32_t* alongZ = yFirst ? smaller : larger;
  const int sx = sign[0];
  const int sy = sign[1];
  const int step = sign[2] * layer;
  for (int tap = 0; tap < Tables::Room; ++tap)
  {
    const int odd = tables.Odd[tap];
    places[tap] =
      ((sx * alongX[tap] - odd) >> 1) + row * ((sy * alongY[tap] - odd) >> 1) + step * alongZ[tap];
  }
}

template <BCCKernel Kernel, class R>
void EvaluatePiecesRow(const BCCBlock<const R>& coefficients, const BCCPositions<R>& x,
  const BCCPosition<R>& y, const BCCPosition<R>& z, const BCCResults<R>& results)
{
  using Traits = PieceTraits<Kernel>;
  using L = Lanes<R>;
  constexpr int Terms = Traits::Degree + 1;
  const hn::ScalableTag<R> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::size_t step = hn::Lanes(d);
  const bool yFirst = y.Offset >= z.Offset;
  const R a = yFirst ? y.Offset : z.Offset;
  const R b = yFirst ? z.Offset : y.Offset;
  const auto& tables = PieceTables<Kernel, R>::Get();
  const PieceWeights<Kernel, R> weights(tables, a, b);
  const Memory<R> memory(coefficients);
  const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(x.Even[0] / 2);
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(x.Even[x.GetSize() - 1] / 2);
  const std::size_t count = (static_cast<std::size_t>(last - first) / (2 * step) + 1) * 2 * step;
  const R* origin = memory.Origin + coefficients.RowStride * (y.Even / 2) +
    coefficients.LayerStride * static_cast<std::int64_t>(z.Even) + first;

  // Polynomials by side (right, left), rank, term, lattice point.
  static thread_local std::vector<R> pieces;
  pieces.resize(2 * 3 * Terms * count);
  for (int side = 0; side < 2; ++side)
  {
    const int sign[3] = { 1 - 2 * side, static_cast<int>(y.Sign), static_cast<int>(z.Sign) };
    std::int32_t places[3][PieceTables<Kernel, R>::Room];
    for (int rank = 0; rank < 3; ++rank)
    {
      FindTaps(tables, rank, sign, yFirst, static_cast<int>(memory.Row),
        static_cast<int>(memory.Layer), places[rank]);
    }
    for (std::size_t i = 0; i < count; i += 2 * step)
    {
      L piece[3][Terms][2];
      if (side == 0)
      {
        SumPiece<0, Traits>(origin + i, places[2], weights.W[2], piece[2]);
      }
      else
      {
        // The lowest terms are those of the right side, t running the other way.
        SumPiece<3, Traits>(origin + i, places[2], weights.W[2], piece[2]);
        for (int n = 0; n < 6; ++n)
        {
          const L right = hn::LoadU(d,
            pieces.data() + static_cast<std::size_t>(2 * Terms + n / 2) * count + i +
              static_cast<std::size_t>(n % 2) * step);
          piece[2][n / 2][n % 2] = n / 2 == 1 ? L(0.0) - right : right;
        }
      }
      SumPiece<3, Traits>(origin + i, places[1], weights.W[1], piece[1]);
      SumPiece<3, Traits>(origin + i, places[0], weights.W[0], piece[0]);
      JoinPieces<Traits::Degree, R>(b, piece[2], piece[1]);
      JoinPieces<Traits::Degree, R>(a, piece[1], piece[0]);
      for (int n = 0; n < 3 * Terms; ++n)
      {
        R* to = pieces.data() + (static_cast<std::size_t>(3 * side * Terms + n)) * count + i;
        hn::StoreU(piece[n / Terms][n % Terms][0].Vector, d, to);
        hn::StoreU(piece[n / Terms][n % Terms][1].Vector, d, to + step);
      }
    }
  }

  using Integer = typename BCCPosition<R>::Integer;
  const auto term = hn::Set(di, static_cast<Integer>(count));
  const auto none = hn::Zero(di);
  // A side is three ranks further, a rank as many terms.
  const auto left = hn::Set(di, static_cast<Integer>(3 * Terms * count));
  const auto rank = hn::Set(di, static_cast<Integer>(Terms * count));
  const auto before = hn::Set(di, static_cast<Integer>(first));
  const auto va = hn::Set(d, a);
  const auto vb = hn::Set(d, b);
  LanesPosition<R> px;
  for (std::size_t n = 0; n < x.GetSize(); n += step)
  {
    px.Load(x, n);
    const auto t = px.Offset.Vector;
    const auto below = [&](auto knot) HWY_ATTR
    { return hn::IfThenElse(hn::RebindMask(di, hn::Lt(t, knot)), rank, none); };
    constexpr int SignBit = 8 * sizeof(R) - 1;
    const auto side = hn::And(hn::ShiftRight<SignBit>(hn::BitCast(di, px.Sign.Vector)), left);
    auto place = hn::Add(
      hn::Add(hn::Sub(hn::ShiftRight<1>(px.Even), before), side), hn::Add(below(va), below(vb)));
    L c[Terms];
    for (int m = 0; m < Terms; ++m)
    {
      c[m] = hn::GatherIndex(d, pieces.data(), place);
      place = hn::Add(place, term);
    }
    L value = c[Terms - 1];
    for (int m = Terms - 2; m >= 0; --m)
    {
      value = value * px.Offset + c[m];
    }
    hn::StoreU(value.Vector, d, results.Value + n);
  }
}
