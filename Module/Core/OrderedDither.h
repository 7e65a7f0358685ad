// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrderedDither_h
#define OrderedDither_h

#include "BayerPattern.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace bravais
{

/**
 * Quantisation of numbers by the thresholds of a pattern.
 *
 * With L levels over a range lo .. hi, a number v is u = (v - lo) / (hi - lo) (L - 1) levels, and
 * becomes floor(u), or the next level where the fraction of u has reached the cell's threshold
 * (rank + 1/2) / cells. With n cells this is, in integers,
 *   level = (GetCount(v) + n - 1 - rank) / n,  GetCount(v) = floor(n u + 1/2),
 * so a constant keeps its mean to half a threshold, 1 / (2 n) of a level. Numbers beyond the range
 * become its end's level, and NaN becomes level 0.
 */
class OrderedDither
{
public:
  static constexpr int MaximumLevels = 256;
  static constexpr int MaximumLog2NumberOfCells = 22; // so that counts fit 31 bits

  /// Levels from 2 to MaximumLevels, a range that is finite and ascending.
  static std::optional<OrderedDither> Create(
    const BayerPattern& pattern, int levels, double lo, double hi);

  const BayerPattern& GetPattern() const { return this->Pattern; }

  /// How many thresholds a number reaches, those of the levels below it included.
  std::int32_t GetCount(double value) const
  {
    const double count = (value - this->Low) * this->Scale;
    const double positive = count > 0.0 ? count : 0.0; // NaN too is 0
    return static_cast<std::int32_t>((positive < this->Highest ? positive : this->Highest) + 0.5);
  }

private:
  OrderedDither(const BayerPattern& pattern, int levels, double lo, double hi);

  BayerPattern Pattern;
  double Low;
  double Scale;   // thresholds a unit of the data
  double Highest; // count of the highest level
};

/// The rows of an image of one type, whose columns are x, x + 1, .. of so many components each.
/// It may be used by several threads.
template <class T>
class OrderedDitherRows
{
public:
  OrderedDitherRows(
    const OrderedDither& dither, std::int64_t x, std::int64_t columns, int components);

  /// Quantises the row of these y and z.
  void Execute(const T* in, std::int64_t y, std::int64_t z, unsigned char* out) const;

private:
  static constexpr bool HasTable = std::is_integral_v<T> && sizeof(T) <= 2;
  static constexpr std::int64_t ShortestRun = 512; // columns

  std::int32_t GetCount(T value) const;

  OrderedDither Dither;
  std::int64_t Values;                  // of a row
  std::vector<std::int32_t> Ranks;      // of a run of values, which can be repeated
  std::vector<std::int32_t> CountTable; // of all numbers of a small type, as if unsigned
};

//------------------------------------------------------------------------------
template <class T>
OrderedDitherRows<T>::OrderedDitherRows(
  const OrderedDither& dither, std::int64_t x, std::int64_t columns, int components)
  : Dither(dither)
  , Values(columns * components)
{
  const BayerPattern& pattern = dither.GetPattern();
  const std::int64_t run = std::min(columns, std::max(pattern.GetSize(), ShortestRun));
  this->Ranks.reserve(static_cast<std::size_t>(run * components));
  for (std::int64_t column = 0; column < run; ++column)
  {
    this->Ranks.insert(this->Ranks.end(), static_cast<std::size_t>(components),
      static_cast<std::int32_t>(pattern.GetAxisRank(0, x + column)));
  }
  if constexpr (HasTable)
  {
    using Index = std::make_unsigned_t<T>;
    for (int index = 0; index <= std::numeric_limits<Index>::max(); ++index)
    {
      this->CountTable.push_back(dither.GetCount(static_cast<T>(index)));
    }
  }
}

//------------------------------------------------------------------------------
template <class T>
std::int32_t OrderedDitherRows<T>::GetCount(T value) const
{
  if constexpr (HasTable)
  {
    return this->CountTable[static_cast<std::make_unsigned_t<T>>(value)];
  }
  else
  {
    return this->Dither.GetCount(static_cast<double>(value));
  }
}

//------------------------------------------------------------------------------
template <class T>
void OrderedDitherRows<T>::Execute(
  const T* in, std::int64_t y, std::int64_t z, unsigned char* __restrict out) const
{
  const BayerPattern& pattern = this->Dither.GetPattern();
  const int bits = pattern.GetLog2NumberOfCells();
  const auto rowRank =
    static_cast<std::int32_t>(pattern.GetAxisRank(1, y) ^ pattern.GetAxisRank(2, z));
  const std::int32_t flip = rowRank ^ ((1 << bits) - 1); // n - 1 - rank is rank ^ (n - 1)
  const std::int32_t* ranks = this->Ranks.data();
  const auto period = static_cast<std::int64_t>(this->Ranks.size());
  for (std::int64_t start = 0; start < this->Values; start += period)
  {
    const std::int64_t run = std::min(period, this->Values - start);
    for (std::int64_t i = 0; i < run; ++i)
    {
      const std::int32_t sum = this->GetCount(in[start + i]) + (ranks[i] ^ flip);
      out[start + i] = static_cast<unsigned char>(sum >> bits);
    }
  }
}

} // namespace bravais

#endif
