// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChirpTransform_h
#define ChirpTransform_h

#include <complex>
#include <cstdint>
#include <vector>

namespace bravais
{

/// One number of each of 8 real lines, which are 4 complex ones: 0 to 3 are real parts, 4 to 7 the
/// imaginary parts of the same lines.
struct alignas(64) LineNumbers
{
  double Values[8];
};

/// The first half of the discrete Fourier transform of complex sequences of any length P,
///   X_m = sum over n of x_n exp(-2 pi i m n / P),  m = 0 .. P / 2,
/// in O(P log P), of 4 sequences side by side with SIMD instructions.
///
/// It is Bluestein's algorithm: with m n = (m^2 + n^2 - (m - n)^2) / 2 the sum is a convolution
/// with a chirp. That is done by Fourier transforms of a length of 2^a or 3 2^a numbers, at least
/// 3/2 P as only half of the result is wanted. They need not bring their numbers in order, since
/// those are but multiplied by the chirp's, in the same order.
class ChirpTransform
{
public:
  using Complex = std::complex<double>;

  explicit ChirpTransform(std::int64_t length);

  /// How many numbers Execute needs room for.
  std::int64_t GetBufferSize() const { return this->Size; }

  /// From the first P numbers to the first P / 2 + 1, in place; the others lose their values.
  void Execute(LineNumbers* numbers) const;

  /// One pass of the inner transforms: it splits sequences of Radix * Part numbers in Radix ones.
  struct Pass
  {
    int Radix; // 2, 3 or 4
    std::int64_t Part;
    std::vector<Complex> Twiddles; // exp(-2 pi i k q / (Radix Part)), k = 1 .. Radix - 1 at each q
  };

private:
  std::int64_t Length;
  std::int64_t Size;
  std::vector<Complex> Chirp;    // exp(-pi i n^2 / P)
  std::vector<Complex> Response; // the transform of the conjugate chirp, over Size
  std::vector<Pass> Passes;
};

/// exp(-pi i numerator / denominator)
std::complex<double> GetRootOfUnity(std::int64_t numerator, std::int64_t denominator);

} // namespace bravais

#endif
