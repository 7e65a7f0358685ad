// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Texels.h"

#include "Rank1Image.h"
#include "Rank1TextureLevels.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

/// The time at which a texture or one of its blocks changed.
vtkMTimeType GetTime(vtkDataObject* texture)
{
  vtkMTimeType time = texture ? texture->GetMTime() : 0;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(texture))
  {
    for (unsigned int block = 0; block < blocks->GetNumberOfBlocks(); ++block)
    {
      vtkDataObject* object = blocks->GetBlock(block);
      time = std::max(time, object ? object->GetMTime() : 0);
    }
  }
  return time;
}

template <class T>
void SampleArrays(const Rank1Sampling& sampling,
  const std::vector<vtkSmartPointer<vtkDataArray>>& arrays, const T*, vtkIdType count,
  const double* uv, const double* footprints, double* values)
{
  const int components = arrays[0]->GetNumberOfComponents();
  std::vector<const T*> levels;
  for (const auto& array : arrays)
  {
    levels.push_back(static_cast<const T*>(array->GetVoidPointer(0)));
  }
  for (vtkIdType point = 0; point < count; ++point)
  {
    double* value = values + point * components;
    const double* p = uv + 2 * point;
    const double* f = footprints + 4 * point;
    const bool known = std::isfinite(p[0]) && std::isfinite(p[1]) && !std::isnan(f[0]) &&
      !std::isnan(f[1]) && !std::isnan(f[2]) && !std::isnan(f[3]);
    std::fill_n(value, components, known ? 0.0 : std::numeric_limits<double>::quiet_NaN());
    if (known)
    {
      VisitRank1Texels(sampling, { p[0], p[1] }, { f[0], f[1], f[2], f[3] },
        [&](int level, std::int64_t texel, double weight)
        {
          const T* from = levels[level] + texel * components;
          for (int c = 0; c < components; ++c)
          {
            value[c] += weight * static_cast<double>(from[c]);
          }
        });
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void Rank1Texels::Clear()
{
  this->Source = nullptr;
  this->Arrays.clear();
  this->Sampling.Levels.clear();
}

//------------------------------------------------------------------------------
int Rank1Texels::GetNumberOfComponents() const
{
  return this->Arrays.empty() ? 0 : this->Arrays[0]->GetNumberOfComponents();
}

//------------------------------------------------------------------------------
bool Rank1Texels::SetSource(vtkDataObject* texture, std::string& why)
{
  const vtkMTimeType time = GetTime(texture);
  if (texture && texture == this->Source && time == this->SourceTime)
  {
    return true;
  }
  this->Clear();
  Rank1TextureLevels levels;
  if (!GetRank1TextureLevels(texture, levels, why))
  {
    return false;
  }
  Rank1Sampling sampling = this->Sampling;
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (vtkImageData* image : levels.Images)
  {
    const auto picture = ReadRank1Image(image, why);
    if (!picture)
    {
      return false;
    }
    if (arrays.empty())
    {
      const glm::dvec2 tiles(picture->Tiles[0], picture->Tiles[1]);
      sampling.Density = GetRank1Density(picture->Lattice.GetSize() * tiles,
        static_cast<double>(picture->Lattice.GetNumberOfPoints()) * tiles.x * tiles.y);
    }
    sampling.Levels.push_back(
      MakeRank1Texture<double>(picture->Lattice, picture->Tiles[0], picture->Tiles[1]));
    arrays.emplace_back(picture->Texels);
  }
  sampling.Counts = { levels.Columns, levels.Rows };
  sampling.IsRSet = levels.IsRSet;
  this->Sampling = sampling;
  this->Arrays = arrays;
  this->Source = texture;
  this->SourceTime = time;
  return true;
}

//------------------------------------------------------------------------------
void Rank1Texels::Sample(
  vtkIdType count, const double* uv, const double* footprints, double* values) const
{
  switch (this->Arrays[0]->GetDataType())
  {
    vtkTemplateMacro(SampleArrays(this->Sampling, this->Arrays, static_cast<const VTK_TT*>(nullptr),
      count, uv, footprints, values));
  }
}

} // namespace bravais
