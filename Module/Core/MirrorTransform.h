// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MirrorTransform_h
#define MirrorTransform_h

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

template <typename T>
class kissfft;

namespace bravais
{

/// The first half of the discrete Fourier transform of a complex sequence of any length P,
///   X_m = sum over n of x_n exp(-2 pi i m n / P),  m = 0 .. P / 2,
/// in O(P log P): directly if P has no prime factor above 5, else as a convolution with a chirp
/// (Bluestein) of a length that has none.
class HalfFourierTransform
{
public:
  using Complex = std::complex<double>;

  explicit HalfFourierTransform(std::int64_t length);

  /// How many numbers both of Execute's arguments must have room for.
  std::int64_t GetBufferSize() const { return this->Size; }

  /// From the first P numbers of `sequence`, which is overwritten, to `spectrum`, of which the
  /// first P / 2 + 1 mean something.
  void Execute(Complex* sequence, Complex* spectrum) const;

private:
  std::int64_t Length;
  std::int64_t Size;             // of the FFT
  std::vector<Complex> Chirp;    // exp(-pi i n^2 / P); empty if direct
  std::vector<Complex> Response; // transform of the conjugate chirp, / Size
  std::shared_ptr<const kissfft<double>> Forward;
  std::shared_ptr<const kissfft<double>> Backward;
};

/// Fourier transforms of the two sets of alternate samples of a line that mirrors continue.
///
/// A line of samples at 0, 1, .. L is continued by whole-sample mirrors at both ends, so its
/// period is 2 L. Its coset 0 are the samples at 0, 2, 4, .., its coset 1 those at 1, 3, .. ; each
/// has P = L samples a period. The transform of coset c,
///   S_m = sum over its samples' positions x in a period of s(x) exp(-pi i m x / L),
/// is real for real samples, and as many m = 0, 1, .. determine it as the coset has samples.
/// Complex "samples" are two lines at once, the real and the imaginary parts.
class MirrorTransform
{
public:
  using Complex = HalfFourierTransform::Complex;

  /// L >= 1.
  explicit MirrorTransform(std::int64_t last);

  /// L / 2 + 1 samples of coset 0, (L + 1) / 2 of coset 1.
  std::int64_t GetNumberOfSamples(int coset) const
  {
    return coset == 0 ? this->Last / 2 + 1 : (this->Last + 1) / 2;
  }

  /// The inverse is scaled by this: it has to be divided by it to return the samples.
  std::int64_t GetScale() const { return this->Last; }

  /// Room that a call needs; give each thread its own.
  struct Scratch
  {
    std::vector<Complex> Sequence;
    std::vector<Complex> Spectrum;
  };
  Scratch MakeScratch() const;

  /// Samples to spectrum, in place.
  void Forward(int coset, Complex* line, Scratch& scratch) const;

  /// Spectrum to samples times GetScale(), in place.
  void Inverse(int coset, Complex* line, Scratch& scratch) const;

private:
  void TransformEven(std::int64_t count, Complex* line, Scratch& scratch) const;

  std::int64_t Last;
  HalfFourierTransform Fourier;
  std::vector<Complex> HalfStep; // exp(-pi i m / L), for even L
};

} // namespace bravais

#endif
