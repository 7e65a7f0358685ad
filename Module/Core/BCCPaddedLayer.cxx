// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCPaddedLayer.h"

#include "BCCLattice.h"
#include "BCCQuasiInterpolation.h"

#include <algorithm>

namespace bravais
{

namespace
{

/// The index inside first..last that the mirrors of an axis send index n of a layer of that parity
/// to: lattice coordinates are 2 n + parity, the mirrors stand at 2 first and 2 last + 1.
int MirrorIndex(int n, int parity, int first, int last)
{
  const int coordinate = BCCLattice::Mirror(2 * (n - first) + parity, 2 * (last - first) + 1);
  return first + (coordinate - parity) / 2;
}

/// Copies one component, as it is.
template <class T, class R>
void CopyLayer(const BCCBlock<const T>& from, int component, const BCCBlock<R>& to)
{
  const BCCExtent& e = to.Extent;
  for (int j = e[2]; j <= e[3]; ++j)
  {
    const T* source = from.GetRow(j, e[4]) +
      (static_cast<std::int64_t>(e[0]) - from.Extent[0]) * from.Components + component;
    R* target = to.GetRow(j, e[4]);
    const int size = e[1] - e[0] + 1;
    for (int i = 0; i < size; ++i)
    {
      target[i] = static_cast<R>(source[static_cast<std::int64_t>(i) * from.Components]);
    }
  }
}

/// Continues layer k of a plane, filled inside `inner`, to the plane's whole width and height.
template <class R>
void MirrorBorders(const BCCExtent& whole, const BCCExtent& inner, int k, const BCCBlock<R>& plane)
{
  const BCCExtent& e = plane.Extent;
  const int parity = k & 1;
  for (int j = inner[2]; j <= inner[3]; ++j)
  {
    R* row = plane.GetRow(j, k) - e[0];
    for (int i = e[0]; i < inner[0]; ++i)
    {
      row[i] = row[MirrorIndex(i, parity, whole[0], whole[1])];
    }
    for (int i = inner[1] + 1; i <= e[1]; ++i)
    {
      row[i] = row[MirrorIndex(i, parity, whole[0], whole[1])];
    }
  }
  for (int j = e[2]; j <= e[3]; ++j)
  {
    if (j < inner[2] || j > inner[3])
    {
      const R* source = plane.GetRow(MirrorIndex(j, parity, whole[2], whole[3]), k);
      std::copy_n(source, e[1] - e[0] + 1, plane.GetRow(j, k));
    }
  }
}

} // namespace

template <class T, class R>
void FillPaddedLayer(BCCKernel kernel, bool quasiInterpolate, const BCCExtent& whole,
  const BCCBlock<const T>& samples, int k, const std::vector<BCCBlock<R>>& planes)
{
  const BCCExtent& e = planes.front().Extent;
  const int image = whole[4] + BCCLattice::Mirror(k - whole[4], whole[5] - whole[4]);
  const BCCExtent inner = { std::max(e[0], whole[0]), std::min(e[1], whole[1]),
    std::max(e[2], whole[2]), std::min(e[3], whole[3]), image, image };
  std::vector<R> interleaved;
  const int components = samples.Components;
  if (quasiInterpolate && components > 1)
  {
    interleaved.resize(static_cast<std::size_t>(inner[1] - inner[0] + 1) *
      static_cast<std::size_t>(inner[3] - inner[2] + 1) * static_cast<std::size_t>(components));
    const BCCBlock<R> layer(interleaved.data(), inner, components);
    QuasiInterpolate(kernel, whole, samples, layer);
  }
  for (int c = 0; c < components; ++c)
  {
    const BCCBlock<R>& plane = planes[static_cast<std::size_t>(c)];
    BCCBlock<R> target(plane.GetRow(inner[2], k) + (inner[0] - e[0]), inner);
    target.RowStride = plane.RowStride;
    if (!interleaved.empty())
    {
      CopyLayer(BCCBlock<const R>(interleaved.data(), inner, components), c, target);
    }
    else if (quasiInterpolate)
    {
      QuasiInterpolate(kernel, whole, samples, target);
    }
    else
    {
      CopyLayer(samples, c, target);
    }
    MirrorBorders(whole, inner, k, plane);
  }
}

#define BRAVAIS_INSTANTIATE(T, R)                                                                  \
  template void FillPaddedLayer(BCCKernel, bool, const BCCExtent&, const BCCBlock<const T>&, int,  \
    const std::vector<BCCBlock<R>>&)

BRAVAIS_INSTANTIATE(char, float);
BRAVAIS_INSTANTIATE(signed char, float);
BRAVAIS_INSTANTIATE(unsigned char, float);
BRAVAIS_INSTANTIATE(short, float);
BRAVAIS_INSTANTIATE(unsigned short, float);
BRAVAIS_INSTANTIATE(int, float);
BRAVAIS_INSTANTIATE(unsigned int, float);
BRAVAIS_INSTANTIATE(float, float);
BRAVAIS_INSTANTIATE(double, double);
BRAVAIS_INSTANTIATE(long, double);
BRAVAIS_INSTANTIATE(unsigned long, double);
BRAVAIS_INSTANTIATE(long long, double);
BRAVAIS_INSTANTIATE(unsigned long long, double);

} // namespace bravais
