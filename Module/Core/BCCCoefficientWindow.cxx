// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCCoefficientWindow.h"

#include "BCCSplineRows.h"

#include <algorithm>

namespace bravais
{

namespace
{
constexpr int FewestLayers = 10;
}

template <class R>
BCCCoefficientWindow<R>::BCCCoefficientWindow(const BCCExtent& padded, int components, double bytes)
  : LayerSize(static_cast<std::size_t>(padded[1] - padded[0] + 1) *
      static_cast<std::size_t>(padded[3] - padded[2] + 1))
{
  const double layers = bytes / (static_cast<double>(this->LayerSize) * components * sizeof(R));
  const int all = padded[5] - padded[4] + 1;
  this->Capacity = static_cast<int>(std::min<double>(all, std::max<double>(FewestLayers, layers)));
  const std::size_t plane = this->LayerSize * static_cast<std::size_t>(this->Capacity);
  this->Memory.resize(plane * static_cast<std::size_t>(components) + GetBCCResultSize(0));
  // Before the first move the window ends below the volume.
  const BCCExtent none = { padded[0], padded[1], padded[2], padded[3], padded[4] - 1,
    padded[4] - 1 };
  for (int c = 0; c < components; ++c)
  {
    this->Planes.emplace_back(this->Memory.data() + static_cast<std::size_t>(c) * plane, none);
  }
}

template <class R>
void BCCCoefficientWindow<R>::MoveTo(int low, int high)
{
  const int first = this->Planes.front().Extent[4];
  const int last = this->Planes.front().Extent[5];
  const int kept = low > last ? 0 : last - low + 1;
  for (BCCBlock<R>& plane : this->Planes)
  {
    if (kept > 0 && low > first)
    {
      const R* from = plane.Data + this->LayerSize * static_cast<std::size_t>(low - first);
      std::copy_n(from, this->LayerSize * static_cast<std::size_t>(kept), plane.Data);
    }
    plane.Extent[4] = low;
    plane.Extent[5] = high;
  }
  this->FirstMissing = std::max(low, last + 1);
}

template <class R>
BCCBlock<const R> BCCCoefficientWindow<R>::GetPlane(int component) const
{
  const BCCBlock<R>& plane = this->Planes[static_cast<std::size_t>(component)];
  return { plane.Data, plane.Extent };
}

template class BCCCoefficientWindow<float>;
template class BCCCoefficientWindow<double>;

} // namespace bravais
