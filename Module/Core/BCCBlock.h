// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCBlock_h
#define BCCBlock_h

#include <array>
#include <cstdint>

namespace bravais
{

/// Inclusive index ranges {i0, i1, j0, j1, k0, k1}. The parity of the index k, not that of
/// k - k0, tells a layer's coset.
using BCCExtent = std::array<int, 6>;

/// Whether there is no index in it.
bool IsEmpty(const BCCExtent& extent);

/// Whether all indices of `inner`, which is not empty, are in `outer`.
bool Contains(const BCCExtent& outer, const BCCExtent& inner);

/// `extent`, a part of `whole`, and one index more on each side where the whole reaches so far.
BCCExtent GrowWithin(const BCCExtent& whole, const BCCExtent& extent);

/// Values of a part of a volume in memory, i fastest, components interleaved.
template <class T>
struct BCCBlock
{
  BCCBlock(T* data, const BCCExtent& extent, int components = 1)
    : Data(data)
    , Extent(extent)
    , Components(components)
    , RowStride((static_cast<std::int64_t>(extent[1]) - extent[0] + 1) * components)
    , LayerStride(RowStride * (static_cast<std::int64_t>(extent[3]) - extent[2] + 1))
  {
  }

  /// The row (j, k) from its first index i = Extent[0] on.
  T* GetRow(int j, int k) const
  {
    return this->Data + this->RowStride * (static_cast<std::int64_t>(j) - this->Extent[2]) +
      this->LayerStride * (static_cast<std::int64_t>(k) - this->Extent[4]);
  }

  T* Data;          ///< the first component at (Extent[0], Extent[2], Extent[4])
  BCCExtent Extent; ///< what Data holds
  int Components;
  std::int64_t RowStride;   ///< values from (i, j, k) to (i, j + 1, k), dense by default
  std::int64_t LayerStride; ///< values from (i, j, k) to (i, j, k + 1), dense by default
};

} // namespace bravais

#endif
