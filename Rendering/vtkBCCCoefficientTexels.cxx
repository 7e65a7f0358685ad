// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCCoefficientTexels.h"

#include "BCCLattice.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSpectralPrefilter.h"
#include "vtkBCCVolumeFrame.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <type_traits>

namespace
{
bravais::BCCExtent ToExtent(const int extent[6])
{
  return { extent[0], extent[1], extent[2], extent[3], extent[4], extent[5] };
}

template <class Function>
void ForEachLayer(const vtkBCCVolumeFrame& frame, const Function& function)
{
  vtkSMPTools::For(static_cast<vtkIdType>(frame.Low[2]), static_cast<vtkIdType>(frame.High[2]) + 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int z = static_cast<int>(begin); z < end; ++z)
      {
        function(z);
      }
    });
}
}

//------------------------------------------------------------------------------
glm::ivec3 vtkBCCCoefficientTexels::GetSize(const vtkBCCVolumeFrame& frame)
{
  const int columns = frame.Extent[1] - frame.Extent[0] + 1;
  const int rows = frame.Extent[3] - frame.Extent[2] + 1;
  const int depth = static_cast<int>(frame.High[2]) / 2 + 1;
  return { columns + 2 * Halo, rows + 2 * Halo, 2 * (depth + 2 * Halo) };
}

//------------------------------------------------------------------------------
int vtkBCCCoefficientTexels::GetSlice(int z) const
{
  // Shifting rounds down for negative z too.
  return (z >> 1) + Halo + (z & 1) * (this->Size.z / 2);
}

//------------------------------------------------------------------------------
float* vtkBCCCoefficientTexels::GetTexel(int i, int j, int slice)
{
  return this->Values.data() +
    ((static_cast<std::size_t>(slice) * this->Size.y + j) * this->Size.x + i) * this->Components;
}

//------------------------------------------------------------------------------
bool vtkBCCCoefficientTexels::Load(const vtkBCCVolumeFrame& frame, vtkDataArray* samples,
  bravais::BCCKernel kernel, bravais::BCCPrefilter prefilter)
{
  this->Size = GetSize(frame);
  this->Components = samples->GetNumberOfComponents();
  this->Values.resize(
    static_cast<std::size_t>(this->Size.x) * this->Size.y * this->Size.z * this->Components);

  // Quasi-interpolation with BCC4 leaves samples as they are.
  const auto local =
    prefilter == bravais::BCCPrefilter::QuasiInterpolation ? kernel : bravais::BCCKernel::BCC4;
  const void* pointer = samples->GetVoidPointer(0);
  std::atomic<bool> good(true);
  ForEachLayer(frame,
    [&](int z)
    {
      switch (samples->GetDataType())
      {
        vtkTemplateMacro(
          good = this->LoadLayer(frame, static_cast<const VTK_TT*>(pointer), local, z) && good);
      }
    });
  if (good && prefilter > bravais::BCCPrefilter::QuasiInterpolation)
  {
    good = this->ApplySpectralPrefilter(frame, kernel, prefilter);
  }
  ForEachLayer(frame, [&](int z) { this->MirrorInSlice(frame, z); });
  this->MirrorSlices(frame);
  return good;
}

//------------------------------------------------------------------------------
bool vtkBCCCoefficientTexels::ApplySpectralPrefilter(
  const vtkBCCVolumeFrame& frame, bravais::BCCKernel kernel, bravais::BCCPrefilter prefilter)
{
  const bravais::BCCExtent whole = ToExtent(frame.Extent);
  bravais::BCCBlock<float> volume(nullptr, whole, this->Components);
  std::vector<float> values(volume.LayerStride * (whole[5] - whole[4] + 1));
  volume.Data = values.data();
  const auto forEachRow = [&](auto&& copy)
  {
    ForEachLayer(frame,
      [&](int z)
      {
        for (int j = whole[2]; j <= whole[3]; ++j)
        {
          copy(volume.GetRow(j, whole[4] + z - static_cast<int>(frame.Low[2])),
            this->GetTexel(Halo, Halo + j - whole[2], this->GetSlice(z)));
        }
      });
  };
  forEachRow([&](float* row, float* texels) { std::copy_n(texels, volume.RowStride, row); });
  const auto parallelFor = [](std::int64_t begin, std::int64_t end, const auto& body)
  { vtkSMPTools::For(begin, end, [&](vtkIdType b, vtkIdType e) { body(b, e); }); };
  const bool good = bravais::ApplySpectralPrefilter(kernel, prefilter, volume, parallelFor);
  forEachRow([&](float* row, float* texels) { std::copy_n(row, volume.RowStride, texels); });
  return good;
}

//------------------------------------------------------------------------------
template <class T>
bool vtkBCCCoefficientTexels::LoadLayer(
  const vtkBCCVolumeFrame& frame, const T* samples, bravais::BCCKernel kernel, int z)
{
  using R = bravais::BCCCoefficient<T>;
  const bravais::BCCExtent whole = ToExtent(frame.Extent);
  const int k = whole[4] + z - static_cast<int>(frame.Low[2]);
  bravais::BCCExtent extent = whole;
  extent[4] = extent[5] = k;
  const bravais::BCCBlock<const T> input(samples, whole, this->Components);

  float* texels = this->GetTexel(Halo, Halo, this->GetSlice(z));
  const std::int64_t stride = static_cast<std::int64_t>(this->Size.x) * this->Components;
  if constexpr (std::is_same_v<R, float>)
  {
    bravais::BCCBlock<float> layer(texels, extent, this->Components);
    layer.RowStride = stride;
    return bravais::QuasiInterpolate(kernel, whole, input, layer);
  }
  else
  {
    const bravais::BCCBlock<R> shape(nullptr, extent, this->Components);
    std::vector<R> values(shape.LayerStride);
    const bravais::BCCBlock<R> layer(values.data(), extent, this->Components);
    const bool good = bravais::QuasiInterpolate(kernel, whole, input, layer);
    for (int j = extent[2]; good && j <= extent[3]; ++j)
    {
      const R* row = layer.GetRow(j, k);
      std::transform(row, row + layer.RowStride, texels + (j - extent[2]) * stride,
        [](R value) { return static_cast<float>(value); });
    }
    return good;
  }
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientTexels::MirrorInSlice(const vtkBCCVolumeFrame& frame, int z)
{
  using bravais::BCCLattice;
  const int odd = z & 1;
  const int slice = this->GetSlice(z);
  const glm::ivec2 last(static_cast<int>(frame.High[0]), static_cast<int>(frame.High[1]));
  const auto source = [&](int texel, int lastOfAxis)
  { return BCCLattice::Mirror(2 * (texel - Halo) + odd, lastOfAxis) / 2 + Halo; };
  for (int j = Halo; j < this->Size.y - Halo; ++j)
  {
    for (int h = 0; h < Halo; ++h)
    {
      for (int i : { h, this->Size.x - 1 - h })
      {
        std::copy_n(this->GetTexel(source(i, last.x), j, slice), this->Components,
          this->GetTexel(i, j, slice));
      }
    }
  }
  for (int h = 0; h < Halo; ++h)
  {
    for (int j : { h, this->Size.y - 1 - h })
    {
      std::copy_n(this->GetTexel(0, source(j, last.y), slice), this->Size.x * this->Components,
        this->GetTexel(0, j, slice));
    }
  }
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientTexels::MirrorSlices(const vtkBCCVolumeFrame& frame)
{
  const int low = static_cast<int>(frame.Low[2]);
  const int high = static_cast<int>(frame.High[2]);
  for (int z = -2 * Halo; z < this->Size.z - 2 * Halo; ++z)
  {
    if (z < low || z > high)
    {
      const int source = bravais::BCCLattice::Mirror(z - low, high - low) + low;
      std::copy_n(this->GetTexel(0, 0, this->GetSlice(source)),
        static_cast<std::size_t>(this->Size.x) * this->Size.y * this->Components,
        this->GetTexel(0, 0, this->GetSlice(z)));
    }
  }
}
