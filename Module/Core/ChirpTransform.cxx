// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Highway compiles this file once for each kind of processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Module/Core/ChirpTransform.cxx"
#include <hwy/foreach_target.h>

#include "ChirpTransform.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace bravais
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
using Complex = std::complex<double>;

/// Some of the four complex lines.
struct Lines
{
  V Re;
  V Im;
};

HWY_INLINE Lines Load(const LineNumbers& from, std::size_t lane)
{
  return { hn::Load(D(), from.Values + lane), hn::Load(D(), from.Values + 4 + lane) };
}

HWY_INLINE void Store(const Lines& a, LineNumbers& to, std::size_t lane)
{
  hn::Store(a.Re, D(), to.Values + lane);
  hn::Store(a.Im, D(), to.Values + 4 + lane);
}

HWY_INLINE Lines operator+(const Lines& a, const Lines& b)
{
  return { hn::Add(a.Re, b.Re), hn::Add(a.Im, b.Im) };
}

HWY_INLINE Lines operator-(const Lines& a, const Lines& b)
{
  return { hn::Sub(a.Re, b.Re), hn::Sub(a.Im, b.Im) };
}

HWY_INLINE Lines operator*(const Lines& a, const Complex& b)
{
  const V re = hn::Set(D(), b.real());
  const V im = hn::Set(D(), b.imag());
  return { hn::NegMulAdd(a.Im, im, hn::Mul(a.Re, re)), hn::MulAdd(a.Im, re, hn::Mul(a.Re, im)) };
}

HWY_INLINE Lines operator*(const Lines& a, double b)
{
  const V factor = hn::Set(D(), b);
  return { hn::Mul(a.Re, factor), hn::Mul(a.Im, factor) };
}

/// a + i b and a - i b.
HWY_INLINE Lines AddTurned(const Lines& a, const Lines& b)
{
  return { hn::Sub(a.Re, b.Im), hn::Add(a.Im, b.Re) };
}

HWY_INLINE Lines SubtractTurned(const Lines& a, const Lines& b)
{
  return { hn::Add(a.Re, b.Im), hn::Sub(a.Im, b.Re) };
}

/// The Fourier transform of Radix numbers, or the inverse one times Radix.
template <int Radix, bool Inverse>
HWY_INLINE void Butterfly(Lines* x)
{
  if constexpr (Radix == 2)
  {
    const Lines sum = x[0] + x[1];
    x[1] = x[0] - x[1];
    x[0] = sum;
  }
  else if constexpr (Radix == 3)
  {
    const Lines sum = x[1] + x[2];
    const Lines middle = x[0] - sum * 0.5;
    const Lines side = (x[1] - x[2]) * (Inverse ? 0.86602540378443865 : -0.86602540378443865);
    x[0] = x[0] + sum;
    x[1] = AddTurned(middle, side);
    x[2] = SubtractTurned(middle, side);
  }
  else
  {
    const Lines even = x[0] + x[2];
    const Lines evenDifference = x[0] - x[2];
    const Lines odd = x[1] + x[3];
    const Lines oddDifference = Inverse ? x[1] - x[3] : x[3] - x[1];
    x[0] = even + odd;
    x[1] = AddTurned(evenDifference, oddDifference);
    x[2] = even - odd;
    x[3] = SubtractTurned(evenDifference, oddDifference);
  }
}

template <int Radix, bool Inverse>
void RunPass(const ChirpTransform::Pass& pass, std::int64_t size, LineNumbers* numbers)
{
  const std::int64_t part = pass.Part;
  for (std::int64_t start = 0; start < size; start += Radix * part)
  {
    const Complex* twiddle = pass.Twiddles.data();
    for (std::int64_t q = start; q < start + part; ++q, twiddle += Radix - 1)
    {
      for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(D()))
      {
        Lines x[Radix];
        for (int k = 0; k < Radix; ++k)
        {
          x[k] = Load(numbers[q + k * part], lane);
        }
        for (int k = 1; Inverse && k < Radix; ++k)
        {
          x[k] = x[k] * std::conj(twiddle[k - 1]);
        }
        Butterfly<Radix, Inverse>(x);
        for (int k = 1; !Inverse && k < Radix; ++k)
        {
          x[k] = x[k] * twiddle[k - 1];
        }
        for (int k = 0; k < Radix; ++k)
        {
          Store(x[k], numbers[q + k * part], lane);
        }
      }
    }
  }
}

template <bool Inverse>
void RunAnyPass(const ChirpTransform::Pass& pass, std::int64_t size, LineNumbers* numbers)
{
  switch (pass.Radix)
  {
    case 2:
      return RunPass<2, Inverse>(pass, size, numbers);
    case 3:
      return RunPass<3, Inverse>(pass, size, numbers);
    default:
      return RunPass<4, Inverse>(pass, size, numbers);
  }
}

void Transform(
  const std::vector<ChirpTransform::Pass>& passes, std::int64_t size, LineNumbers* numbers)
{
  for (const ChirpTransform::Pass& pass : passes)
  {
    RunAnyPass<false>(pass, size, numbers);
  }
}

void TransformBack(
  const std::vector<ChirpTransform::Pass>& passes, std::int64_t size, LineNumbers* numbers)
{
  for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass)
  {
    RunAnyPass<true>(*pass, size, numbers);
  }
}

void Multiply(const Complex* factors, std::int64_t count, LineNumbers* numbers)
{
  for (std::int64_t n = 0; n < count; ++n)
  {
    for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(D()))
    {
      Store(Load(numbers[n], lane) * factors[n], numbers[n], lane);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace bravais
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bravais
{
namespace
{

HWY_EXPORT(Transform);
HWY_EXPORT(TransformBack);
HWY_EXPORT(Multiply);

/// The smallest 2^a or 3 2^a that is not less.
std::int64_t GetFastSize(std::int64_t least)
{
  std::int64_t size = 1;
  while (size < least)
  {
    size *= 2;
  }
  return size >= 4 && size / 4 * 3 >= least ? size / 4 * 3 : size;
}

} // namespace

std::complex<double> GetRootOfUnity(std::int64_t numerator, std::int64_t denominator)
{
  const double angle = -3.14159265358979323846 *
    static_cast<double>(numerator % (2 * denominator)) / static_cast<double>(denominator);
  return { std::cos(angle), std::sin(angle) };
}

ChirpTransform::ChirpTransform(std::int64_t length)
  : Length(length)
  // The chirp is needed at the differences m - n, from -(length - 1) to length / 2.
  , Size(GetFastSize(length + length / 2))
{
  for (std::int64_t size = this->Size; size > 1; size = this->Passes.back().Part)
  {
    const int radix = size % 3 == 0 ? 3 : size % 4 == 0 ? 4 : 2;
    Pass pass{ radix, size / radix, {} };
    for (std::int64_t q = 0; q < pass.Part; ++q)
    {
      for (int k = 1; k < radix; ++k)
      {
        pass.Twiddles.push_back(GetRootOfUnity(2 * k * q, size));
      }
    }
    this->Passes.push_back(std::move(pass));
  }

  std::vector<LineNumbers> response(static_cast<std::size_t>(this->Size), LineNumbers{});
  for (std::int64_t n = 0; n < length; ++n)
  {
    this->Chirp.push_back(GetRootOfUnity(n * n, length));
    const Complex value = std::conj(this->Chirp.back()) / static_cast<double>(this->Size);
    LineNumbers numbers{};
    numbers.Values[0] = value.real();
    numbers.Values[4] = value.imag();
    response[static_cast<std::size_t>((this->Size - n) % this->Size)] = numbers;
    if (n <= length / 2)
    {
      response[static_cast<std::size_t>(n)] = numbers;
    }
  }
  HWY_DYNAMIC_DISPATCH(Transform)(this->Passes, this->Size, response.data());
  for (const LineNumbers& numbers : response)
  {
    this->Response.emplace_back(numbers.Values[0], numbers.Values[4]);
  }
}

void ChirpTransform::Execute(LineNumbers* numbers) const
{
  HWY_DYNAMIC_DISPATCH(Multiply)(this->Chirp.data(), this->Length, numbers);
  std::fill(numbers + this->Length, numbers + this->Size, LineNumbers{});
  HWY_DYNAMIC_DISPATCH(Transform)(this->Passes, this->Size, numbers);
  HWY_DYNAMIC_DISPATCH(Multiply)(this->Response.data(), this->Size, numbers);
  HWY_DYNAMIC_DISPATCH(TransformBack)(this->Passes, this->Size, numbers);
  HWY_DYNAMIC_DISPATCH(Multiply)(this->Chirp.data(), this->Length / 2 + 1, numbers);
}

} // namespace bravais
#endif
