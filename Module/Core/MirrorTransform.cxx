// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MirrorTransform.h"

#include <algorithm>

namespace bravais
{
namespace
{

LineNumbers Multiply(const LineNumbers& a, const std::complex<double>& b)
{
  LineNumbers product;
  for (int n = 0; n < 4; ++n)
  {
    product.Values[n] = a.Values[n] * b.real() - a.Values[n + 4] * b.imag();
    product.Values[n + 4] = a.Values[n] * b.imag() + a.Values[n + 4] * b.real();
  }
  return product;
}

/// Real parts for imaginary parts.
LineNumbers Swap(const LineNumbers& a)
{
  LineNumbers swapped;
  std::rotate_copy(a.Values, a.Values + 4, a.Values + 8, swapped.Values);
  return swapped;
}

void NegateOdd(std::int64_t count, LineNumbers* lines)
{
  for (std::int64_t m = 1; m < count; m += 2)
  {
    for (double& value : lines[m].Values)
    {
      value = -value;
    }
  }
}

} // namespace

MirrorTransform::MirrorTransform(std::int64_t last)
  : Last(last)
  , Fourier(last)
{
  for (std::int64_t m = 0; last % 2 == 0 && m < last / 2; ++m)
  {
    this->HalfStep.push_back(GetRootOfUnity(m, last));
  }
}

/// Of a sequence that is even about its sample 0: its own inverse but for the scale.
void MirrorTransform::TransformEven(std::int64_t count, LineNumbers* lines) const
{
  for (std::int64_t n = count; n < this->Last; ++n)
  {
    lines[n] = lines[this->Last - n];
  }
  this->Fourier.Execute(lines);
}

void MirrorTransform::Forward(int coset, LineNumbers* lines) const
{
  const std::int64_t count = this->GetNumberOfSamples(coset);
  if (coset == 0)
  {
    this->TransformEven(count, lines);
  }
  else if (this->Last % 2 == 1) // even about its last sample, at L: shifts the phase by pi m
  {
    std::reverse(lines, lines + count);
    this->TransformEven(count, lines);
    NegateOdd(count, lines);
  }
  else // even about positions between samples
  {
    std::reverse_copy(lines, lines + count, lines + count);
    this->Fourier.Execute(lines);
    for (std::int64_t m = 0; m < count; ++m)
    {
      lines[m] = Multiply(lines[m], this->HalfStep[m]);
    }
  }
}

void MirrorTransform::Inverse(int coset, LineNumbers* lines) const
{
  const std::int64_t count = this->GetNumberOfSamples(coset);
  if (coset == 0)
  {
    this->TransformEven(count, lines);
  }
  else if (this->Last % 2 == 1)
  {
    NegateOdd(count, lines);
    this->TransformEven(count, lines);
    std::reverse(lines, lines + count);
  }
  else // the inverse transform of a is the transform of a with real and imaginary part swapped
  {
    lines[count] = LineNumbers{};
    for (std::int64_t m = 1; m < count; ++m)
    {
      lines[this->Last - m] = Swap(Multiply(lines[m], this->HalfStep[m]));
      lines[m] = Multiply(lines[m], std::conj(this->HalfStep[m]));
    }
    std::transform(lines, lines + count, lines, Swap);
    this->Fourier.Execute(lines);
    std::transform(lines, lines + count, lines, Swap);
  }
}

} // namespace bravais
