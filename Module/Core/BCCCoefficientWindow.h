// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCCoefficientWindow_h
#define BCCCoefficientWindow_h

#include "BCCBlock.h"
#include "BCCPaddedLayer.h"

#include <cstddef>
#include <vector>

namespace bravais
{

/// A few layers of coefficients, one plane a component, in memory that moves along a volume.
///
///     window.MoveTo(low, high);
///     for (int k = window.GetFirstMissing(); k <= window.GetLast(); ++k)
///       FillPaddedLayer(..., k, window.GetPlanes());
///     EvaluateBCCRow(kernel, window.GetPlane(0), ...);
template <class R>
class BCCCoefficientWindow
{
public:
  /// Room for the indices (i, j) of `padded` and for as many of its layers as `bytes` hold, but for
  /// 10 at least, of which a point needs 8.
  BCCCoefficientWindow(const BCCExtent& padded, int components, double bytes);

  /// Number of layers there is room for.
  int GetCapacity() const { return this->Capacity; }

  /// Makes the window start at layer `low` and end at `high`, which must not go back. Layers that
  /// were in it stay; the others, from GetFirstMissing on, have to be filled.
  void MoveTo(int low, int high);
  int GetFirstMissing() const { return this->FirstMissing; }
  int GetLast() const { return this->Planes.front().Extent[5]; }

  const std::vector<BCCBlock<R>>& GetPlanes() const { return this->Planes; }
  BCCBlock<const R> GetPlane(int component) const;

private:
  int Capacity;
  int FirstMissing = 0;
  std::size_t LayerSize;
  std::vector<R> Memory;
  std::vector<BCCBlock<R>> Planes;
};

} // namespace bravais

#endif
