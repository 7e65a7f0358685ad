// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MirrorTransform_h
#define MirrorTransform_h

#include "ChirpTransform.h"

namespace bravais
{

/// Fourier transforms of the two sets of alternate samples of a line that mirrors continue, of 8
/// lines at once.
///
/// A line of samples at 0, 1, .. L is continued by whole-sample mirrors at both ends, so its
/// period is 2 L. Its coset 0 are the samples at 0, 2, 4, .., its coset 1 those at 1, 3, .. ; each
/// has P = L samples a period. The transform of coset c,
///   S_m = sum over its samples' positions x in a period of s(x) exp(-pi i m x / L),
/// is real for real samples, and as many m = 0, 1, .. determine it as the coset has samples.
class MirrorTransform
{
public:
  /// L >= 1.
  explicit MirrorTransform(std::int64_t last);

  /// L / 2 + 1 samples of coset 0, (L + 1) / 2 of coset 1.
  std::int64_t GetNumberOfSamples(int coset) const
  {
    return coset == 0 ? this->Last / 2 + 1 : (this->Last + 1) / 2;
  }

  /// How many numbers the lines need room for, of which their samples are the first.
  std::int64_t GetBufferSize() const { return this->Fourier.GetBufferSize(); }

  /// The inverse has to be divided by this to return the samples.
  std::int64_t GetScale() const { return this->Last; }

  /// Samples to spectrum, in place.
  void Forward(int coset, LineNumbers* lines) const;

  /// Spectrum to samples times GetScale(), in place.
  void Inverse(int coset, LineNumbers* lines) const;

private:
  void TransformEven(std::int64_t count, LineNumbers* lines) const;

  std::int64_t Last;
  ChirpTransform Fourier;
  std::vector<std::complex<double>> HalfStep; // exp(-pi i m / L), for even L
};

} // namespace bravais

#endif
