// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCSpectralPrefilter.h"

#include "BCCResponse.h"
#include "LineBlock.h"

#include <algorithm>

namespace bravais
{
namespace
{

using Direction = LineBlock::Direction;

template <class R>
class SpectralFilter
{
public:
  SpectralFilter(BCCKernel kernel, BCCPrefilter prefilter, const BCCBlock<R>& volume)
    : Volume(volume)
    , Nx(GetSize(volume.Extent, 0))
    , Ny(GetSize(volume.Extent, 1))
    , Nk(GetSize(volume.Extent, 2))
    , X(2 * this->Nx - 1)
    , Y(2 * this->Ny - 1)
    , Z(this->Nk - 1)
    , Response(kernel, prefilter, { 2 * this->Nx - 1, 2 * this->Ny - 1, this->Nk - 1 })
  {
  }

  std::int64_t GetNumberOfLayers() const { return this->Nk; }
  std::int64_t GetNumberOfColumnBlocks() const
  {
    return (this->Nx + LineBlock::Size - 1) / LineBlock::Size * this->Ny;
  }

  /// Along x and y, or back, in layers begin .. end - 1.
  void TransformLayers(std::int64_t begin, std::int64_t end, Direction direction) const
  {
    for (int coset = 0; coset < 2; ++coset)
    {
      LineBlock x(this->X, coset);
      LineBlock y(this->Y, coset);
      const bool skipFirst = ((this->Volume.Extent[4] + begin) & 1) != coset;
      for (std::int64_t layer = begin + (skipFirst ? 1 : 0); layer < end; layer += 2)
      {
        for (int c = 0; c < this->Volume.Components; ++c)
        {
          this->TransformLayer(
            x, y, this->Volume.Data + this->Volume.LayerStride * layer + c, direction);
        }
      }
    }
  }

  /// Along z, the filter, and back, in blocks of columns begin .. end - 1.
  void FilterColumns(std::int64_t begin, std::int64_t end) const
  {
    LineBlock first(this->Z, 0);
    LineBlock second(this->Z, 1);
    std::vector<BCCResponse::Value> filter(
      static_cast<std::size_t>(first.GetLength() * LineBlock::Size));
    const std::int64_t blocks = (this->Nx + LineBlock::Size - 1) / LineBlock::Size;
    const std::int64_t step = this->Volume.Components;
    const std::int64_t layer = this->Volume.LayerStride;
    for (std::int64_t block = begin; block < end; ++block)
    {
      const std::int64_t my = block / blocks;
      const std::int64_t mx = block % blocks * LineBlock::Size;
      const std::int64_t count = std::min(LineBlock::Size, this->Nx - mx);
      for (std::int64_t l = 0; l < count; ++l)
      {
        this->Response.GetColumn(mx + l, my, filter.data() + l * first.GetLength());
      }
      for (int c = 0; c < this->Volume.Components; ++c)
      {
        R* data = this->Volume.Data + this->Volume.RowStride * my + mx * step + c;
        first.Load(data, count, step, 2 * layer);
        second.Load(data + layer, count, step, 2 * layer);
        first.Execute(Direction::Forward);
        second.Execute(Direction::Forward);
        for (std::int64_t l = 0; l < count; ++l)
        {
          this->FilterColumn(first, second, l, filter.data() + l * first.GetLength());
        }
        first.Execute(Direction::Inverse);
        second.Execute(Direction::Inverse);
        first.Store(data, count, step, 2 * layer);
        second.Store(data + layer, count, step, 2 * layer);
      }
    }
  }

private:
  static std::int64_t GetSize(const BCCExtent& extent, int axis)
  {
    return static_cast<std::int64_t>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
  }

  void TransformLayer(LineBlock& x, LineBlock& y, R* data, Direction direction) const
  {
    const std::int64_t step = this->Volume.Components;
    const std::int64_t row = this->Volume.RowStride;
    if (direction == Direction::Forward)
    {
      TransformLines(x, this->Ny, row, step, data, direction);
    }
    TransformLines(y, this->Nx, step, row, data, direction);
    if (direction == Direction::Inverse)
    {
      TransformLines(x, this->Ny, row, step, data, direction);
    }
  }

  /// `count` lines of a layer that are `across` values apart, their numbers `along` values apart.
  static void TransformLines(LineBlock& lines, std::int64_t count, std::int64_t across,
    std::int64_t along, R* data, Direction direction)
  {
    for (std::int64_t l = 0; l < count; l += LineBlock::Size)
    {
      const std::int64_t some = std::min(LineBlock::Size, count - l);
      lines.Load(data + l * across, some, across, along);
      lines.Execute(direction);
      lines.Store(data + l * across, some, across, along);
    }
  }

  /// Applies the filter to column l, with the scale that the inverse transforms leave.
  void FilterColumn(
    LineBlock& first, LineBlock& second, std::int64_t l, const BCCResponse::Value* filter) const
  {
    const double scale = 1.0 / static_cast<double>(this->X.GetScale()) /
      static_cast<double>(this->Y.GetScale()) / static_cast<double>(this->Z.GetScale());
    for (std::int64_t m = 0; m < second.GetLength(); ++m)
    {
      const double f0 = scale * first.Get(m)[l];
      const double f1 = scale * second.Get(m)[l];
      first.Get(m)[l] = filter[m].Same * f0 + filter[m].Other * f1;
      second.Get(m)[l] = filter[m].Same * f1 + filter[m].Other * f0;
    }
    if (first.GetLength() > second.GetLength()) // w.z = pi / 2, where the second coset has nothing
    {
      const std::int64_t m = second.GetLength();
      first.Get(m)[l] *= scale * filter[m].Same;
    }
  }

  const BCCBlock<R>& Volume;
  std::int64_t Nx, Ny, Nk;
  MirrorTransform X, Y, Z;
  BCCResponse Response;
};

/// Runs `body` on 0 .. count - 1 in batches, reporting progress from `start` to `finish`.
bool RunInBatches(std::int64_t count, double start, double finish, const ParallelFor& parallelFor,
  const ProgressFunction& progress, const std::function<void(std::int64_t, std::int64_t)>& body)
{
  constexpr std::int64_t Batches = 8;
  for (std::int64_t batch = 0; batch < Batches; ++batch)
  {
    const std::int64_t begin = count * batch / Batches;
    const std::int64_t end = count * (batch + 1) / Batches;
    if (begin == end)
    {
      continue;
    }
    if (progress && !progress(start + (finish - start) * static_cast<double>(batch) / Batches))
    {
      return false;
    }
    if (parallelFor)
    {
      parallelFor(begin, end, body);
    }
    else
    {
      body(begin, end);
    }
  }
  return true;
}

} // namespace

template <class R>
bool ApplySpectralPrefilter(BCCKernel kernel, BCCPrefilter prefilter, const BCCBlock<R>& volume,
  const ParallelFor& parallelFor, const ProgressFunction& progress)
{
  if ((prefilter != BCCPrefilter::Interpolation && prefilter != BCCPrefilter::Projection) ||
    !IsDefined(kernel, prefilter) || IsEmpty(volume.Extent) || volume.Components < 1 ||
    volume.Extent[4] == volume.Extent[5])
  {
    return false;
  }
  if (kernel == BCCKernel::BCC4 && prefilter == BCCPrefilter::Interpolation)
  {
    return true; // BCC4 is 1 at its centre and 0 at all other lattice points
  }
  using Index = std::int64_t;
  const SpectralFilter<R> filter(kernel, prefilter, volume);
  const Index layers = filter.GetNumberOfLayers();
  const Index columns = filter.GetNumberOfColumnBlocks();
  return RunInBatches(layers, 0.0, 0.3, parallelFor, progress,
           [&](Index begin, Index end)
           { filter.TransformLayers(begin, end, Direction::Forward); }) &&
    RunInBatches(columns, 0.3, 0.7, parallelFor, progress,
      [&](Index begin, Index end) { filter.FilterColumns(begin, end); }) &&
    RunInBatches(layers, 0.7, 1.0, parallelFor, progress,
      [&](Index begin, Index end) { filter.TransformLayers(begin, end, Direction::Inverse); });
}

template bool ApplySpectralPrefilter<float>(
  BCCKernel, BCCPrefilter, const BCCBlock<float>&, const ParallelFor&, const ProgressFunction&);
template bool ApplySpectralPrefilter<double>(
  BCCKernel, BCCPrefilter, const BCCBlock<double>&, const ParallelFor&, const ProgressFunction&);

} // namespace bravais
