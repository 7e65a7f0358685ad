// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCCoefficientTexels.h"

#include "BCCLattice.h"
#include "vtkBCCVolumeFrame.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

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
void vtkBCCCoefficientTexels::Pack(const vtkBCCVolumeFrame& frame, vtkDataArray* coefficients)
{
  this->Size = GetSize(frame);
  this->Components = coefficients->GetNumberOfComponents();
  this->Values.resize(static_cast<std::size_t>(this->GetCount() + 3) / 4 * 4 + 4);
  const void* values = coefficients->GetVoidPointer(0);
  const bool doubles = coefficients->GetDataType() == VTK_DOUBLE;
  vtkSMPTools::For(static_cast<vtkIdType>(frame.Low[2]), static_cast<vtkIdType>(frame.High[2]) + 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int z = static_cast<int>(begin); z < end; ++z)
      {
        if (doubles)
        {
          this->PackLayer(frame, static_cast<const double*>(values), z);
        }
        else
        {
          this->PackLayer(frame, static_cast<const float*>(values), z);
        }
        this->MirrorInSlice(frame, z);
      }
    });
  this->MirrorSlices(frame);
}

//------------------------------------------------------------------------------
template <class T>
void vtkBCCCoefficientTexels::PackLayer(
  const vtkBCCVolumeFrame& frame, const T* coefficients, int z)
{
  const std::size_t rows = frame.Extent[3] - frame.Extent[2] + 1;
  const std::size_t row = (frame.Extent[1] - frame.Extent[0] + 1) * this->Components;
  const T* from = coefficients + (z - static_cast<int>(frame.Low[2])) * rows * row;
  for (std::size_t j = 0; j < rows; ++j, from += row)
  {
    std::transform(from, from + row,
      this->GetTexel(Halo, Halo + static_cast<int>(j), this->GetSlice(z)),
      [](T value) { return static_cast<float>(value); });
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

//------------------------------------------------------------------------------
std::vector<double> vtkBCCCoefficientTexels::RoundToHalf()
{
  std::vector<double> errors(this->Components);
  std::mutex merging;
  const vtkIdType row = static_cast<vtkIdType>(this->Size.x) * this->Components;
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Size.y) * this->Size.z,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> most(this->Components);
      for (vtkIdType n = begin * row; n < end * row; ++n)
      {
        const float value = this->Values[n];
        const float rounded = glm::unpackHalf1x16(glm::packHalf1x16(value));
        this->Values[n] = rounded;
        if (std::isfinite(value))
        {
          double& error = most[n % this->Components];
          error = std::max<double>(error, std::abs(rounded - value));
        }
      }
      const std::lock_guard<std::mutex> lock(merging);
      std::transform(most.begin(), most.end(), errors.begin(), errors.begin(),
        [](double a, double b) { return std::max(a, b); });
    });
  return errors;
}
