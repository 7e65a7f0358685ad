// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Texels.h"

#include "Rank1Image.h"
#include "Rank1TextureLevels.h"
#include "Rank1TileFile.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/half.h>

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

/// Looks up points; find(level, texel) is where a texel of type T is, or nullptr.
template <class T, class Find>
void SamplePoints(const Rank1Sampling& sampling, int components, vtkIdType count, const double* uv,
  const double* footprints, double* values, const Find& find)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (vtkIdType point = 0; point < count; ++point)
  {
    double* value = values + point * components;
    const double* p = uv + 2 * point;
    const double* f = footprints + 4 * point;
    const bool known = std::isfinite(p[0]) && std::isfinite(p[1]) &&
      std::none_of(f, f + 4, [](double number) { return std::isnan(number); });
    std::fill_n(value, components, known ? 0.0 : nan);
    if (known)
    {
      VisitRank1Texels(sampling, { p[0], p[1] }, { f[0], f[1], f[2], f[3] },
        [&](int level, std::int64_t texel, double weight)
        {
          const T* from = find(level, texel);
          for (int c = 0; c < components; ++c)
          {
            value[c] += from ? weight * static_cast<double>(from[c]) : nan;
          }
        });
    }
  }
}

template <class T>
void SampleFile(const Rank1Sampling& sampling, const Rank1TileFile& file, vtkIdType count,
  const double* uv, const double* footprints, double* values)
{
  Rank1TileFile::Reader reader(file);
  SamplePoints<T>(sampling, file.GetNumberOfComponents(), count, uv, footprints, values,
    [&](int level, std::int64_t texel)
    { return static_cast<const T*>(reader.Find(level, texel)); });
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
  SamplePoints<T>(sampling, components, count, uv, footprints, values,
    [&](int level, std::int64_t texel) { return levels[level] + texel * components; });
}

} // namespace

//------------------------------------------------------------------------------
Rank1Texels::Rank1Texels() = default;

//------------------------------------------------------------------------------
Rank1Texels::~Rank1Texels() = default;

//------------------------------------------------------------------------------
void Rank1Texels::Clear()
{
  this->File.reset();
  this->Source = nullptr;
  this->Arrays.clear();
  this->Sampling.Levels.clear();
}

//------------------------------------------------------------------------------
int Rank1Texels::GetNumberOfComponents() const
{
  if (this->File)
  {
    return this->File->GetNumberOfComponents();
  }
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
bool Rank1Texels::SetFile(const std::string& name, int megabytes, std::string& why)
{
  const std::time_t time = OIIO::Filesystem::last_write_time(name);
  if (this->File && name == this->FileName && time == this->FileTime &&
    megabytes == this->Megabytes)
  {
    return true;
  }
  this->Clear();
  auto file = std::make_unique<Rank1TileFile>();
  if (!file->Open(name, megabytes, why))
  {
    return false;
  }
  const Rank1TileLayout& layout = file->GetLayout();
  const auto& [n, g1, g2] = layout.Generator;
  const glm::dvec2 size(layout.Domain[1] - layout.Domain[0], layout.Domain[3] - layout.Domain[2]);
  Rank1Sampling sampling = this->Sampling;
  for (const int rows : layout.Rows)
  {
    for (const int columns : layout.Columns)
    {
      const auto lattice = Rank1Lattice::Create(n, g1, g2, size / glm::dvec2(columns, rows));
      if (!lattice)
      {
        why = "The file '" + name +
          "' is damaged: " + ExplainRank1Lattice(n, g1, g2, size.x / columns, size.y / rows);
        return false;
      }
      sampling.Levels.push_back(MakeRank1Texture<double>(*lattice, columns, rows));
    }
  }
  sampling.Counts = { layout.Columns.size(), layout.Rows.size() };
  sampling.IsRSet = true;
  sampling.Density = GetRank1Density(
    size, static_cast<double>(n) * layout.Tiles[0] * static_cast<double>(layout.Tiles[1]));
  this->Sampling = sampling;
  this->File = std::move(file);
  this->FileName = name;
  this->FileTime = time;
  this->Megabytes = megabytes;
  return true;
}

//------------------------------------------------------------------------------
void Rank1Texels::Sample(
  vtkIdType count, const double* uv, const double* footprints, double* values) const
{
  if (this->File)
  {
    switch (this->File->GetType().basetype)
    {
      case OIIO::TypeDesc::UINT8:
        SampleFile<unsigned char>(this->Sampling, *this->File, count, uv, footprints, values);
        break;
      case OIIO::TypeDesc::UINT16:
        SampleFile<unsigned short>(this->Sampling, *this->File, count, uv, footprints, values);
        break;
      case OIIO::TypeDesc::HALF:
        SampleFile<half>(this->Sampling, *this->File, count, uv, footprints, values);
        break;
      default:
        SampleFile<float>(this->Sampling, *this->File, count, uv, footprints, values);
    }
    return;
  }
  switch (this->Arrays[0]->GetDataType())
  {
    vtkTemplateMacro(SampleArrays(this->Sampling, this->Arrays, static_cast<const VTK_TT*>(nullptr),
      count, uv, footprints, values));
  }
}

} // namespace bravais
