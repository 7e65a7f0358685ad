// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCSpectralPrefilter.h"

#include "BCCResponse.h"
#include "MirrorTransform.h"

#include <algorithm>

namespace bravais
{
namespace
{

using Complex = MirrorTransform::Complex;

enum class Direction
{
  Forward,
  Inverse
};

/// Lines are taken in blocks, to use all of each cache line that is touched.
constexpr std::int64_t BlockSize = 16;

/// Up to BlockSize parallel lines, two to a complex number.
class LineBlock
{
public:
  LineBlock(const MirrorTransform& transform, int coset)
    : Transform(transform)
    , Coset(coset)
    , Length(transform.GetNumberOfSamples(coset))
    , Lines(static_cast<std::size_t>(this->Length * (BlockSize / 2)))
    , Scratch(transform.MakeScratch())
  {
  }

  std::int64_t GetLength() const { return this->Length; }

  /// The number n of line l.
  double& Get(std::int64_t l, std::int64_t n)
  {
    return reinterpret_cast<double(&)[2]>(this->Lines[(l / 2) * this->Length + n])[l % 2];
  }

  template <class R>
  void Load(const R* data, std::int64_t count, std::int64_t lineStride, std::int64_t stride)
  {
    this->Count = count;
    if (count % 2 == 1)
    {
      std::fill_n(this->Lines.begin() + count / 2 * this->Length, this->Length, Complex());
    }
    for (std::int64_t n = 0; n < this->Length; ++n, data += stride)
    {
      for (std::int64_t l = 0; l < count; ++l)
      {
        this->Get(l, n) = static_cast<double>(data[l * lineStride]);
      }
    }
  }

  template <class R>
  void Store(R* data, std::int64_t lineStride, std::int64_t stride)
  {
    for (std::int64_t n = 0; n < this->Length; ++n, data += stride)
    {
      for (std::int64_t l = 0; l < this->Count; ++l)
      {
        data[l * lineStride] = static_cast<R>(this->Get(l, n));
      }
    }
  }

  void Execute(Direction direction)
  {
    for (std::int64_t pair = 0; 2 * pair < this->Count; ++pair)
    {
      Complex* line = this->Lines.data() + pair * this->Length;
      if (direction == Direction::Forward)
      {
        this->Transform.Forward(this->Coset, line, this->Scratch);
      }
      else
      {
        this->Transform.Inverse(this->Coset, line, this->Scratch);
      }
    }
  }

private:
  const MirrorTransform& Transform;
  int Coset;
  std::int64_t Length;
  std::int64_t Count = 0;
  std::vector<Complex> Lines;
  MirrorTransform::Scratch Scratch;
};

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
    return (this->Nx + BlockSize - 1) / BlockSize * this->Ny;
  }

  /// Along x and y, or back, in layers begin .. end - 1.
  void TransformLayers(std::int64_t begin, std::int64_t end, Direction direction) const
  {
    for (int coset = 0; coset < 2; ++coset)
    {
      LineBlock x(this->X, coset);
      LineBlock y(this->Y, coset);
      for (std::int64_t layer = begin; layer < end; ++layer)
      {
        const int k = static_cast<int>(this->Volume.Extent[4] + layer);
        for (int c = 0; (k & 1) == coset && c < this->Volume.Components; ++c)
        {
          R* data = this->Volume.Data + this->Volume.LayerStride * layer + c;
          if (direction == Direction::Forward)
          {
            this->TransformRows(x, data, direction);
            this->TransformColumns(y, data, direction);
          }
          else
          {
            this->TransformColumns(y, data, direction);
            this->TransformRows(x, data, direction);
          }
        }
      }
    }
  }

  /// Along z, the filter, and back, in blocks of columns begin .. end - 1.
  void FilterColumns(std::int64_t begin, std::int64_t end) const
  {
    LineBlock first(this->Z, 0);
    LineBlock second(this->Z, 1);
    const std::int64_t depth = this->Response.GetDepth();
    std::vector<BCCResponse::Value> filter(static_cast<std::size_t>(depth * BlockSize));
    const std::int64_t blocks = (this->Nx + BlockSize - 1) / BlockSize;
    const std::int64_t step = this->Volume.Components;
    const std::int64_t stride = 2 * this->Volume.LayerStride;
    for (std::int64_t block = begin; block < end; ++block)
    {
      const std::int64_t my = block / blocks;
      const std::int64_t mx = block % blocks * BlockSize;
      const std::int64_t count = std::min(BlockSize, this->Nx - mx);
      for (std::int64_t l = 0; l < count; ++l)
      {
        this->Response.GetColumn(mx + l, my, filter.data() + l * depth);
      }
      for (int c = 0; c < this->Volume.Components; ++c)
      {
        R* data = this->Volume.Data + this->Volume.RowStride * my + mx * step + c;
        first.Load(data, count, step, stride);
        second.Load(data + this->Volume.LayerStride, count, step, stride);
        first.Execute(Direction::Forward);
        second.Execute(Direction::Forward);
        for (std::int64_t l = 0; l < count; ++l)
        {
          this->FilterColumn(first, second, l, filter.data() + l * depth);
        }
        first.Execute(Direction::Inverse);
        second.Execute(Direction::Inverse);
        first.Store(data, step, stride);
        second.Store(data + this->Volume.LayerStride, step, stride);
      }
    }
  }

private:
  static std::int64_t GetSize(const BCCExtent& extent, int axis)
  {
    return static_cast<std::int64_t>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
  }

  void TransformRows(LineBlock& lines, R* data, Direction direction) const
  {
    const std::int64_t stride = this->Volume.RowStride;
    for (std::int64_t j = 0; j < this->Ny; j += BlockSize)
    {
      lines.Load(
        data + j * stride, std::min(BlockSize, this->Ny - j), stride, this->Volume.Components);
      lines.Execute(direction);
      lines.Store(data + j * stride, stride, this->Volume.Components);
    }
  }

  void TransformColumns(LineBlock& lines, R* data, Direction direction) const
  {
    const std::int64_t step = this->Volume.Components;
    for (std::int64_t i = 0; i < this->Nx; i += BlockSize)
    {
      lines.Load(data + i * step, std::min(BlockSize, this->Nx - i), step, this->Volume.RowStride);
      lines.Execute(direction);
      lines.Store(data + i * step, step, this->Volume.RowStride);
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
      const double f0 = scale * first.Get(l, m);
      const double f1 = scale * second.Get(l, m);
      first.Get(l, m) = filter[m].Same * f0 + filter[m].Other * f1;
      second.Get(l, m) = filter[m].Same * f1 + filter[m].Other * f0;
    }
    if (first.GetLength() > second.GetLength()) // w.z = pi / 2, where the second coset has nothing
    {
      const std::int64_t m = second.GetLength();
      first.Get(l, m) *= scale * filter[m].Same;
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
