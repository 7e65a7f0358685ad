// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LineBlock_h
#define LineBlock_h

#include "MirrorTransform.h"

namespace bravais
{

/// Up to 8 parallel lines of a volume, copied side by side to be transformed.
class LineBlock
{
public:
  static constexpr std::int64_t Size = 8;

  enum class Direction
  {
    Forward,
    Inverse
  };

  /// For lines along the samples of one coset.
  LineBlock(const MirrorTransform& transform, int coset)
    : Transform(transform)
    , Coset(coset)
    , Length(transform.GetNumberOfSamples(coset))
    , Lines(static_cast<std::size_t>(transform.GetBufferSize()))
  {
  }

  std::int64_t GetLength() const { return this->Length; }

  /// The numbers n of all lines, Size of them.
  double* Get(std::int64_t n) { return this->Lines[static_cast<std::size_t>(n)].Values; }

  /// Lines that are `across` values apart, with their numbers `along` values apart.
  template <class R>
  void Load(const R* data, std::int64_t count, std::int64_t across, std::int64_t along)
  {
    for (std::int64_t n = 0; n < this->Length; ++n, data += along)
    {
      double* numbers = this->Get(n);
      if (count == Size && across == 1)
      {
        for (std::int64_t l = 0; l < Size; ++l)
        {
          numbers[l] = static_cast<double>(data[l]);
        }
        continue;
      }
      for (std::int64_t l = 0; l < Size; ++l)
      {
        numbers[l] = l < count ? static_cast<double>(data[l * across]) : 0.0;
      }
    }
  }

  template <class R>
  void Store(R* data, std::int64_t count, std::int64_t across, std::int64_t along)
  {
    for (std::int64_t n = 0; n < this->Length; ++n, data += along)
    {
      const double* numbers = this->Get(n);
      for (std::int64_t l = 0; l < count; ++l)
      {
        data[l * across] = static_cast<R>(numbers[l]);
      }
    }
  }

  void Execute(Direction direction)
  {
    if (direction == Direction::Forward)
    {
      this->Transform.Forward(this->Coset, this->Lines.data());
    }
    else
    {
      this->Transform.Inverse(this->Coset, this->Lines.data());
    }
  }

private:
  const MirrorTransform& Transform;
  int Coset;
  std::int64_t Length;
  std::vector<LineNumbers> Lines;
};

} // namespace bravais

#endif
