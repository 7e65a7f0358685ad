// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BSplineSampler.h"

#include <algorithm>
#include <cmath>

namespace bravais
{
namespace
{

int Continue(std::int64_t n, int count, BSplineBorder border)
{
  const auto modulo = [](std::int64_t a, std::int64_t b) { return (a % b + b) % b; };
  const std::int64_t last = count - 1;
  switch (border)
  {
    case BSplineBorder::Repeat:
      return static_cast<int>(modulo(n, count));
    case BSplineBorder::Mirror:
    {
      const std::int64_t rest = last > 0 ? modulo(n, 2 * last) : 0;
      return static_cast<int>(std::min(rest, 2 * last - rest));
    }
    default:
      return static_cast<int>(std::clamp<std::int64_t>(n, 0, last));
  }
}

/// sums[i] = sum over taps of weights[t] rows[indices[t]][i], each row `size` numbers.
void Combine(
  const double* const* rows, const double* weights, int taps, std::int64_t size, double* sums)
{
  for (std::int64_t i = 0; i < size; ++i)
  {
    sums[i] = weights[0] * rows[0][i];
  }
  for (int t = 1; t < taps; ++t)
  {
    const double weight = weights[t];
    const double* row = rows[t];
    for (std::int64_t i = 0; i < size; ++i)
    {
      sums[i] += weight * row[i];
    }
  }
}

} // namespace

BSplineAxis::BSplineAxis(
  int degree, BSplineBorder border, int count, double start, double step, int first, int last)
  : Taps(degree + 1)
{
  std::vector<double> w(this->Taps + 1);
  for (std::int64_t n = first; n <= last; ++n)
  {
    const double x = start + step * static_cast<double>(n) - 0.5 * (degree - 1);
    const double base = std::floor(x);
    const double t = x - base;
    // w[j + 1] is the B-spline of degree p, of support 0 to p + 1, at t + p - j; w[0] stays 0.
    std::fill(w.begin(), w.end(), 0.0);
    w[1] = 1.0;
    for (int p = 1; p <= degree; ++p)
    {
      for (int j = p; j >= 0; --j)
      {
        w[j + 1] = ((t + p - j) * w[j] + (1.0 + j - t) * w[j + 1]) / p;
      }
    }
    for (int j = 0; j <= degree; ++j)
    {
      this->Indices.push_back(Continue(static_cast<std::int64_t>(base) + j, count, border));
      this->Weights.push_back(w[j + 1]);
    }
  }
}

int BSplineAxis::GetFirstIndex() const
{
  return *std::min_element(this->Indices.begin(), this->Indices.end());
}

int BSplineAxis::GetLastIndex() const
{
  return *std::max_element(this->Indices.begin(), this->Indices.end());
}

template <class T>
BSplineSampler<T>::BSplineSampler(const T* coefficients, const glm::ivec3& dimensions, int stride,
  int components, const std::array<const BSplineAxis*, 3>& axes)
  : Coefficients(coefficients)
  , Dimensions(dimensions)
  , Stride(stride)
  , Components(components)
  , Axes(axes)
  , Slices(axes[2]->GetNumberOfTaps())
{
}

template <class T>
const std::vector<double>& BSplineSampler<T>::Evaluate(int k)
{
  const BSplineAxis& z = *this->Axes[2];
  const int* needed = z.GetIndices(k);
  std::vector<const double*> rows;
  for (int t = 0; t < z.GetNumberOfTaps(); ++t)
  {
    rows.push_back(this->GetSlice(needed[t], needed)->Values.data());
  }
  const std::int64_t size = std::int64_t{ this->Components } *
    this->Axes[0]->GetNumberOfPositions() * this->Axes[1]->GetNumberOfPositions();
  this->Values.resize(size);
  Combine(rows.data(), z.GetWeights(k), z.GetNumberOfTaps(), size, this->Values.data());
  return this->Values;
}

/// The interpolated layer, if need be in place of one that is not `needed`.
template <class T>
auto BSplineSampler<T>::GetSlice(int layer, const int* needed) -> const Slice*
{
  const int* end = needed + this->Axes[2]->GetNumberOfTaps();
  Slice* unused = nullptr;
  for (Slice& slice : this->Slices)
  {
    if (slice.Layer == layer)
    {
      return &slice;
    }
    if (!unused && std::find(needed, end, slice.Layer) == end)
    {
      unused = &slice;
    }
  }
  this->Fill(*unused, layer);
  return unused;
}

template <class T>
void BSplineSampler<T>::Fill(Slice& slice, int layer)
{
  const BSplineAxis& x = *this->Axes[0];
  const BSplineAxis& y = *this->Axes[1];
  const int c = this->Components;
  const int taps = x.GetNumberOfTaps();
  const int firstRow = y.GetFirstIndex();
  const int rowCount = y.GetLastIndex() - firstRow + 1;
  const std::int64_t row = std::int64_t{ x.GetNumberOfPositions() } * c;
  const std::int64_t inRow = std::int64_t{ this->Dimensions.x } * this->Stride;
  this->Rows.resize(row * rowCount);
  const T* in =
    this->Coefficients + inRow * (std::int64_t{ this->Dimensions.y } * layer + firstRow);
  double* out = this->Rows.data();
  for (int j = 0; j < rowCount; ++j, in += inRow)
  {
    for (int i = 0; i < x.GetNumberOfPositions(); ++i)
    {
      const int* indices = x.GetIndices(i);
      const double* weights = x.GetWeights(i);
      for (int a = 0; a < c; ++a)
      {
        double sum = 0.0;
        for (int t = 0; t < taps; ++t)
        {
          sum += weights[t] * in[std::int64_t{ indices[t] } * this->Stride + a];
        }
        *out++ = sum;
      }
    }
  }

  slice.Layer = layer;
  slice.Values.resize(row * y.GetNumberOfPositions());
  const int yTaps = y.GetNumberOfTaps();
  std::vector<const double*> rows(yTaps);
  for (int j = 0; j < y.GetNumberOfPositions(); ++j)
  {
    for (int t = 0; t < yTaps; ++t)
    {
      rows[t] = this->Rows.data() + row * (y.GetIndices(j)[t] - firstRow);
    }
    Combine(rows.data(), y.GetWeights(j), yTaps, row, slice.Values.data() + row * j);
  }
}

template class BSplineSampler<float>;
template class BSplineSampler<double>;

} // namespace bravais
