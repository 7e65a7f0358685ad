// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TextureInput.h"

#include "Rank1Image.h"
#include "Rank1Index.h"
#include "Rank1Level.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

namespace
{
constexpr int MaximumPoints = 1 << 24; // of a lattice: floats tell integers apart up to there
constexpr int MostLog2Columns = 12;

/// The value of a full colour or opacity.
double GetOne(int type)
{
  return type == VTK_UNSIGNED_CHAR ? 255.0 : type == VTK_UNSIGNED_SHORT ? 65535.0 : 1.0;
}

int Log2Above(vtkIdType value)
{
  int result = 0;
  while ((vtkIdType{ 1 } << result) < value)
  {
    ++result;
  }
  return result;
}
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRank1TextureInput::GetTime(vtkDataObject* texture)
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

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::SetSource(vtkDataObject* texture, std::string& why)
{
  const vtkMTimeType time = vtkRank1TextureInput::GetTime(texture);
  if (!texture || texture != this->Source || time != this->SourceTime)
  {
    this->Source = texture;
    this->SourceTime = time;
    this->Refusal.clear();
    this->Texels.clear();
    this->Rows = 0;
    if (!this->Load(texture, this->Refusal))
    {
      this->Texels.clear();
    }
    this->LoadTime.Modified();
  }
  why = this->Refusal;
  return why.empty();
}

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::Load(vtkDataObject* texture, std::string& why)
{
  if (!texture)
  {
    why = "There is no texture; the second input port takes a rank-1 image, or a pyramid of them.";
    return false;
  }
  if (!bravais::GetRank1TextureLevels(texture, this->Levels, why))
  {
    return false;
  }
  this->PowerOfTwo = true;
  this->Tiled = false;
  for (Numbers* numbers :
    { &this->ToBasis, &this->Index, &this->Shares, &this->Basis, &this->Shape })
  {
    numbers->clear();
  }
  for (std::size_t level = 0; level < this->Levels.Images.size(); ++level)
  {
    if (!this->AddLevel(level, why))
    {
      return false;
    }
  }
  this->Components = this->Texels[0]->GetNumberOfComponents();
  if (!this->CheckTexels(why))
  {
    return false;
  }
  this->Translucent = this->IsTranslucent();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::AddLevel(std::size_t level, std::string& why)
{
  const auto image = bravais::ReadRank1Image(this->Levels.Images[level], why);
  if (!image)
  {
    return false;
  }
  const std::int64_t n = image->Lattice.GetNumberOfPoints();
  if (n > MaximumPoints)
  {
    why = "The texture has " + std::to_string(n) + " texels in a tile; at most " +
      std::to_string(MaximumPoints) + " were expected.";
    return false;
  }
  const auto numbers =
    bravais::MakeRank1Texture<float>(image->Lattice, image->Tiles[0], image->Tiles[1]);
  const auto add = [](Numbers& to, float x, float y, float z, float w) {
    to.push_back({ x, y, z, w });
  };
  const auto real = [](int number) { return static_cast<float>(number); };
  add(this->ToBasis, numbers.ToBasis.x, numbers.ToBasis.y, numbers.ToBasis.z, numbers.ToBasis.w);
  add(this->Index, real(numbers.NumberOfPoints), real(numbers.Indices.x), real(numbers.Indices.y),
    0.0f);
  add(this->Shares, numbers.IndexShares.x, numbers.IndexShares.y, numbers.Reciprocal, 0.0f);
  add(this->Basis, real(numbers.Basis.x), real(numbers.Basis.y), real(numbers.Basis.z),
    real(numbers.Basis.w));
  add(
    this->Shape, real(numbers.Tiles.x), real(numbers.Tiles.y), numbers.Metric.y, numbers.Metric.z);
  if (level == 0)
  {
    const glm::dvec2 tiles(image->Tiles[0], image->Tiles[1]);
    const glm::dvec2 density = bravais::GetRank1Density(
      image->Lattice.GetSize() * tiles, static_cast<double>(n) * tiles.x * tiles.y);
    this->Density[0] = static_cast<float>(density.x);
    this->Density[1] = static_cast<float>(density.y);
  }
  this->PowerOfTwo = this->PowerOfTwo && (n & (n - 1)) == 0;
  this->Tiled = this->Tiled || image->Tiles[0] > 1 || image->Tiles[1] > 1;
  this->Texels.push_back(image->Texels);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::CheckTexels(std::string& why) const
{
  const int type = this->Texels[0]->GetDataType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT &&
    type != VTK_DOUBLE)
  {
    why = std::string("The texels are of type ") + this->Texels[0]->GetDataTypeAsString() +
      "; colours were expected: unsigned char, unsigned short, float or double.";
    return false;
  }
  if (this->Components < 1 || this->Components > 4)
  {
    why = "The texels have " + std::to_string(this->Components) +
      " components; 1 to 4 were "
      "expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::IsTranslucent() const
{
  if (this->Components % 2 != 0)
  {
    return false;
  }
  const auto isTranslucent = [this](vtkDataArray* texels)
  {
    double range[2];
    texels->GetRange(range, this->Components - 1);
    return range[0] < GetOne(texels->GetDataType());
  };
  return std::any_of(this->Texels.begin(), this->Texels.end(), isTranslucent);
}

//------------------------------------------------------------------------------
bool vtkRank1TextureInput::Fold(int maximumSize, std::string& why)
{
  if (this->Rows > 0)
  {
    return true;
  }
  vtkIdType total = 0;
  for (vtkDataArray* texels : this->Texels)
  {
    total += texels->GetNumberOfTuples();
  }
  // Wider rows than usual for those that need them.
  const int mostLog2 = Log2Above(vtkIdType{ maximumSize } / 2 + 1);
  this->Log2Columns =
    std::min({ MostLog2Columns, mostLog2, Log2Above(this->Texels[0]->GetNumberOfTuples()) });
  vtkIdType rows = 0;
  for (;; ++this->Log2Columns)
  {
    const vtkIdType columns = vtkIdType{ 1 } << this->Log2Columns;
    this->FirstRows.clear();
    rows = 0;
    for (vtkDataArray* texels : this->Texels)
    {
      this->FirstRows.push_back(static_cast<int>(std::min<vtkIdType>(rows, maximumSize)));
      rows += (texels->GetNumberOfTuples() + columns - 1) / columns;
    }
    if (rows <= maximumSize)
    {
      break;
    }
    if (this->Log2Columns >= mostLog2)
    {
      why = "The texture has " + std::to_string(total) + " texels; at most " +
        std::to_string(vtkIdType{ maximumSize } << mostLog2) +
        " were expected, as this GPU's textures have up to " + std::to_string(maximumSize) +
        " texels on a side.";
      return false;
    }
  }
  this->Rows = static_cast<int>(rows);
  for (std::size_t level = 0; level < this->Texels.size(); ++level)
  {
    this->Index[level][3] = static_cast<float>(this->FirstRows[level]);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRank1TextureInput::GetConstants() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<float>::max_digits10);
  const auto declare = [&text](const char* name, const Numbers& numbers)
  {
    text << "const vec4 " << name << "[] = vec4[](";
    const char* separator = "";
    for (const std::array<float, 4>& four : numbers)
    {
      text << separator << "vec4(" << four[0] << ", " << four[1] << ", " << four[2] << ", "
           << four[3] << ")";
      separator = ", ";
    }
    text << ");\n";
  };
  declare("Rank1ToBasis", this->ToBasis);
  declare("Rank1Indices", this->Index);
  declare("Rank1Shares", this->Shares);
  declare("Rank1Basis", this->Basis);
  declare("Rank1Shape", this->Shape);
  text << "const int Rank1Log2Columns = " << this->Log2Columns << ";\n"
       << "const vec2 Rank1Density = vec2(" << this->Density[0] << ", " << this->Density[1]
       << ");\n";
  return text.str();
}
