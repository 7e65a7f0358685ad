// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// To be compiled without contraction of a * b + c, so that vectorised and remaining columns of a
// row round alike; Core.cmake says so.

#include "BCCQuasiInterpolation.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace bravais
{
namespace
{

template <class T, class R>
void ConvertRow(std::int64_t count, const T* samples, R* coefficients)
{
  std::transform(samples, samples + count, coefficients, [](T v) { return static_cast<R>(v); });
}

template <class T, class R>
void AddRows(
  std::int64_t count, const T* __restrict below, const T* __restrict above, R* __restrict sums)
{
  for (std::int64_t p = 0; p < count; ++p)
  {
    sums[p] = static_cast<R>(below[p]) + static_cast<R>(above[p]);
  }
}

/// Makes one layer of coefficients. The four rows of neighbours of a row are, for both of the
/// adjacent layers, rows j - 1 and j of an even layer, j and j + 1 of an odd one; columns
/// likewise. The mirror repeats the first or the last of these, which is the same as clamping.
template <class T, class R>
class LayerFilter
{
public:
  LayerFilter(BCCKernel kernel, const BCCExtent& whole, const BCCBlock<const T>& samples,
    const BCCBlock<R>& coefficients)
    : Center(static_cast<R>(GetQuasiInterpolant(kernel).Center))
    , Neighbor(static_cast<R>(GetQuasiInterpolant(kernel).Neighbor))
    , Whole(whole)
    , Samples(samples)
    , Coefficients(coefficients)
    , Columns(static_cast<std::int64_t>(coefficients.Extent[1]) - coefficients.Extent[0] + 1)
    , Lower((this->Columns + 1) * samples.Components)
    , Upper(this->Lower.size())
  {
  }

  void Execute(int k)
  {
    const BCCExtent& extent = this->Coefficients.Extent;
    const int first = (k & 1) ? 0 : -1;
    this->SumRows(this->Lower.data(), extent[2] + first, k);
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      this->SumRows(this->Upper.data(), j + first + 1, k);
      this->CombineRow(j, k);
      std::swap(this->Lower, this->Upper);
    }
  }

private:
  /// The sums of the two neighbours below and above, over row j of the adjacent layers of k, with
  /// one column more than there are coefficients.
  void SumRows(R* sums, int j, int k) const
  {
    const BCCExtent& whole = this->Whole;
    const int row = std::clamp(j, whole[2], whole[3]);
    const int below = k > whole[4] ? k - 1 : k + 1;
    const int above = k < whole[5] ? k + 1 : k - 1;
    const std::int64_t step = this->Samples.Components;
    const std::int64_t left =
      static_cast<std::int64_t>(this->Coefficients.Extent[0]) - ((k & 1) ? 0 : 1);
    const bool mirrorLeft = left < whole[0];
    const bool mirrorRight = !mirrorLeft && left + this->Columns > whole[1];
    const std::int64_t start = (left + (mirrorLeft ? 1 : 0) - this->Samples.Extent[0]) * step;
    const std::int64_t count = (this->Columns + 1 - (mirrorLeft || mirrorRight ? 1 : 0)) * step;

    R* inside = sums + (mirrorLeft ? step : 0);
    AddRows(count, this->Samples.GetRow(row, below) + start,
      this->Samples.GetRow(row, above) + start, inside);
    if (mirrorLeft)
    {
      std::copy_n(inside, step, sums);
    }
    if (mirrorRight)
    {
      std::copy_n(inside + count - step, step, inside + count);
    }
  }

  void CombineRow(int j, int k) const
  {
    const std::int64_t step = this->Samples.Components;
    const std::int64_t count = this->Columns * step;
    const T* __restrict in =
      this->Samples.GetRow(j, k) + (this->Coefficients.Extent[0] - this->Samples.Extent[0]) * step;
    const R* __restrict lower = this->Lower.data();
    const R* __restrict upper = this->Upper.data();
    R* __restrict out = this->Coefficients.GetRow(j, k);
    const R center = this->Center;
    const R neighbor = this->Neighbor;
    for (std::int64_t p = 0; p < count; ++p)
    {
      const R sum = (lower[p] + upper[p]) + (lower[p + step] + upper[p + step]);
      out[p] = center * static_cast<R>(in[p]) + neighbor * sum;
    }
  }

  R Center;
  R Neighbor;
  const BCCExtent& Whole;
  const BCCBlock<const T>& Samples;
  const BCCBlock<R>& Coefficients;
  std::int64_t Columns;
  std::vector<R> Lower; // column sums of the lower and the upper row of neighbours
  std::vector<R> Upper;
};

}

BCCQuasiInterpolant GetQuasiInterpolant(BCCKernel kernel)
{
  switch (kernel)
  {
    case BCCKernel::BCC7:
    case BCCKernel::BCC8:
      return { 5.0 / 3.0, -1.0 / 12.0 };
    case BCCKernel::BCC12:
      return { 7.0 / 3.0, -1.0 / 6.0 };
    case BCCKernel::BCC4:
      break;
  }
  return { 1.0, 0.0 };
}

template <class T, class R>
bool QuasiInterpolate(BCCKernel kernel, const BCCExtent& whole, const BCCBlock<const T>& samples,
  const BCCBlock<R>& coefficients)
{
  const BCCExtent& extent = coefficients.Extent;
  if (IsEmpty(extent) || !Contains(whole, extent) || whole[4] == whole[5] ||
    samples.Components < 1 || samples.Components != coefficients.Components ||
    !Contains(samples.Extent, GrowWithin(whole, extent)))
  {
    return false;
  }
  if (kernel == BCCKernel::BCC4)
  {
    const std::int64_t columns = static_cast<std::int64_t>(extent[1]) - extent[0] + 1;
    const std::int64_t skipped =
      (static_cast<std::int64_t>(extent[0]) - samples.Extent[0]) * samples.Components;
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        ConvertRow(
          columns * samples.Components, samples.GetRow(j, k) + skipped, coefficients.GetRow(j, k));
      }
    }
    return true;
  }
  LayerFilter<T, R> filter(kernel, whole, samples, coefficients);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    filter.Execute(k);
  }
  return true;
}

#define INSTANTIATE(T, R)                                                                          \
  template bool QuasiInterpolate<T, R>(                                                            \
    BCCKernel, const BCCExtent&, const BCCBlock<const T>&, const BCCBlock<R>&)
#define INSTANTIATE_BOTH(T)                                                                        \
  INSTANTIATE(T, float);                                                                           \
  INSTANTIATE(T, double)

INSTANTIATE_BOTH(char);
INSTANTIATE_BOTH(signed char);
INSTANTIATE_BOTH(unsigned char);
INSTANTIATE_BOTH(short);
INSTANTIATE_BOTH(unsigned short);
INSTANTIATE_BOTH(int);
INSTANTIATE_BOTH(unsigned int);
INSTANTIATE_BOTH(float);
INSTANTIATE(double, double);
INSTANTIATE(long, double);
INSTANTIATE(unsigned long, double);
INSTANTIATE(long long, double);
INSTANTIATE(unsigned long long, double);

} // namespace bravais
