// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MirrorTransform.h"

#include <algorithm>
#include <cmath>
#include <kissfft/kissfft.hh>

namespace bravais
{
namespace
{

using Complex = std::complex<double>;

constexpr double Pi = 3.14159265358979323846;

bool IsFast(std::int64_t length)
{
  for (const int factor : { 2, 3, 5 })
  {
    while (length % factor == 0)
    {
      length /= factor;
    }
  }
  return length == 1;
}

std::int64_t GetTransformSize(std::int64_t length)
{
  if (IsFast(length))
  {
    return length;
  }
  // The chirp is needed at the differences m - n, from -(length - 1) to length / 2.
  std::int64_t size = length + length / 2;
  while (!IsFast(size))
  {
    ++size;
  }
  return size;
}

/// exp(-pi i numerator / denominator)
Complex Root(std::int64_t numerator, std::int64_t denominator)
{
  const double angle = -Pi * static_cast<double>(numerator % (2 * denominator)) / denominator;
  return { std::cos(angle), std::sin(angle) };
}

// std::complex's own product looks for infinities.
Complex Multiply(const Complex& a, const Complex& b)
{
  return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
}

Complex Swap(const Complex& a)
{
  return { a.imag(), a.real() };
}

void NegateOdd(std::int64_t count, Complex* line)
{
  for (std::int64_t m = 1; m < count; m += 2)
  {
    line[m] = -line[m];
  }
}

} // namespace

HalfFourierTransform::HalfFourierTransform(std::int64_t length)
  : Length(length)
  , Size(GetTransformSize(length))
  , Forward(std::make_shared<kissfft<double>>(static_cast<std::size_t>(this->Size), false))
  , Backward(std::make_shared<kissfft<double>>(static_cast<std::size_t>(this->Size), true))
{
  if (this->Size == length)
  {
    return;
  }
  for (std::int64_t n = 0; n < length; ++n)
  {
    this->Chirp.push_back(Root(n * n, length));
  }
  std::vector<Complex> kernel(this->Size);
  for (std::int64_t n = 0; n < length; ++n)
  {
    const Complex value = std::conj(this->Chirp[n]) / static_cast<double>(this->Size);
    if (n <= length / 2)
    {
      kernel[n] = value;
    }
    kernel[(this->Size - n) % this->Size] = value;
  }
  this->Response.resize(this->Size);
  this->Forward->transform(kernel.data(), this->Response.data());
}

void HalfFourierTransform::Execute(Complex* sequence, Complex* spectrum) const
{
  if (this->Chirp.empty())
  {
    this->Forward->transform(sequence, spectrum);
    return;
  }
  for (std::int64_t n = 0; n < this->Length; ++n)
  {
    sequence[n] = Multiply(sequence[n], this->Chirp[n]);
  }
  std::fill(sequence + this->Length, sequence + this->Size, Complex());
  this->Forward->transform(sequence, spectrum);
  for (std::int64_t n = 0; n < this->Size; ++n)
  {
    sequence[n] = Multiply(spectrum[n], this->Response[n]);
  }
  this->Backward->transform(sequence, spectrum);
  for (std::int64_t m = 0; m <= this->Length / 2; ++m)
  {
    spectrum[m] = Multiply(spectrum[m], this->Chirp[m]);
  }
}

MirrorTransform::MirrorTransform(std::int64_t last)
  : Last(last)
  , Fourier(last)
{
  for (std::int64_t m = 0; last % 2 == 0 && m < last / 2; ++m)
  {
    this->HalfStep.push_back(Root(m, last));
  }
}

MirrorTransform::Scratch MirrorTransform::MakeScratch() const
{
  const auto size = static_cast<std::size_t>(this->Fourier.GetBufferSize());
  return { std::vector<Complex>(size), std::vector<Complex>(size) };
}

/// Of a sequence that is even about its sample 0: its own inverse but for the scale.
void MirrorTransform::TransformEven(std::int64_t count, Complex* line, Scratch& scratch) const
{
  Complex* sequence = scratch.Sequence.data();
  std::copy_n(line, count, sequence);
  for (std::int64_t n = count; n < this->Last; ++n)
  {
    sequence[n] = line[this->Last - n];
  }
  this->Fourier.Execute(sequence, scratch.Spectrum.data());
  std::copy_n(scratch.Spectrum.data(), count, line);
}

void MirrorTransform::Forward(int coset, Complex* line, Scratch& scratch) const
{
  const std::int64_t count = this->GetNumberOfSamples(coset);
  if (coset == 0)
  {
    this->TransformEven(count, line, scratch);
  }
  else if (this->Last % 2 == 1) // even about its last sample, at L: shifts the phase by pi m
  {
    std::reverse(line, line + count);
    this->TransformEven(count, line, scratch);
    NegateOdd(count, line);
  }
  else // even about positions between samples
  {
    std::copy_n(line, count, scratch.Sequence.data());
    std::reverse_copy(line, line + count, scratch.Sequence.data() + count);
    this->Fourier.Execute(scratch.Sequence.data(), scratch.Spectrum.data());
    for (std::int64_t m = 0; m < count; ++m)
    {
      line[m] = Multiply(scratch.Spectrum[m], this->HalfStep[m]);
    }
  }
}

void MirrorTransform::Inverse(int coset, Complex* line, Scratch& scratch) const
{
  const std::int64_t count = this->GetNumberOfSamples(coset);
  if (coset == 0)
  {
    this->TransformEven(count, line, scratch);
  }
  else if (this->Last % 2 == 1)
  {
    NegateOdd(count, line);
    this->TransformEven(count, line, scratch);
    std::reverse(line, line + count);
  }
  else // the inverse transform of a is the transform of a with real and imaginary part swapped
  {
    std::vector<Complex>& sequence = scratch.Sequence;
    sequence[count] = 0.0;
    for (std::int64_t m = 0; m < count; ++m)
    {
      sequence[m] = Swap(Multiply(line[m], std::conj(this->HalfStep[m])));
      if (m > 0)
      {
        sequence[this->Last - m] = Swap(Multiply(line[m], this->HalfStep[m]));
      }
    }
    this->Fourier.Execute(sequence.data(), scratch.Spectrum.data());
    std::transform(scratch.Spectrum.data(), scratch.Spectrum.data() + count, line, Swap);
  }
}

} // namespace bravais
