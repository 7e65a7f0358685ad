// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1TextureLevels.h"

#include "LatticeTag.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>

namespace bravais
{

namespace
{

using Dimensions = std::array<int, 3>; ///< n, S, T

Dimensions GetDimensions(vtkImageData* image)
{
  Dimensions n;
  image->GetDimensions(n.data());
  return n;
}

std::string Join(const Dimensions& n)
{
  return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

/// Halvings of a number of tiles, rounded down, until one is left.
int CountHalvings(int tiles)
{
  int count = 0;
  for (; tiles > 0; tiles /= 2)
  {
    ++count;
  }
  return count;
}

bool CollectImages(vtkDataObject* data, std::vector<vtkImageData*>& images, std::string& why)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  const unsigned int count = blocks ? blocks->GetNumberOfBlocks() : 1;
  for (unsigned int block = 0; block < count; ++block)
  {
    vtkDataObject* object = blocks ? blocks->GetBlock(block) : data;
    const std::string name = blocks ? "Block " + std::to_string(block) : "The input";
    auto* image = vtkImageData::SafeDownCast(object);
    if (!HasLatticeTag(object, Rank1Tag) || image->GetNumberOfPoints() == 0 ||
      !image->GetPointData()->GetScalars())
    {
      why = name +
        " of the texture is no rank-1 image with point scalars; such images were expected, whose "
        "field data say Lattice = Rank1.";
      return false;
    }
    images.push_back(image);
  }
  if (images.empty())
  {
    why = "The texture has 0 blocks; at least one rank-1 image was expected.";
    return false;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool GetRank1TextureLevels(vtkDataObject* data, Rank1TextureLevels& levels, std::string& why)
{
  levels = Rank1TextureLevels();
  if (!CollectImages(data, levels.Images, why))
  {
    return false;
  }
  const Dimensions base = GetDimensions(levels.Images[0]);
  const std::size_t count = levels.Images.size();
  levels.IsRSet = count > 1 && GetDimensions(levels.Images[1])[0] == base[0];
  levels.Columns = levels.IsRSet ? CountHalvings(base[1]) : static_cast<int>(count);
  levels.Rows = levels.IsRSet ? CountHalvings(base[2]) : 1;
  if (count != static_cast<std::size_t>(levels.Columns) * levels.Rows)
  {
    why = "The r-set of a base of " + std::to_string(base[1]) + " x " + std::to_string(base[2]) +
      " tiles has " + std::to_string(count) + " members; " +
      std::to_string(levels.Columns * levels.Rows) + " were expected.";
    return false;
  }
  vtkDataArray* values = levels.Images[0]->GetPointData()->GetScalars();
  for (std::size_t index = 0; index < count; ++index)
  {
    const int i = static_cast<int>(index) % levels.Columns;
    const int j = static_cast<int>(index) / levels.Columns;
    const Dimensions expected = levels.IsRSet
      ? Dimensions{ base[0], std::max(1, base[1] >> i), std::max(1, base[2] >> j) }
      : Dimensions{ i < 16 ? base[0] >> (2 * i) : 0, base[1], base[2] };
    const Dimensions n = GetDimensions(levels.Images[index]);
    if (n != expected)
    {
      why = "Block " + std::to_string(index) + " of the texture has dimensions " + Join(n) + "; " +
        Join(expected) + " were expected of this " + (levels.IsRSet ? "r-set." : "pyramid.");
      return false;
    }
    vtkDataArray* own = levels.Images[index]->GetPointData()->GetScalars();
    if (own->GetDataType() != values->GetDataType() ||
      own->GetNumberOfComponents() != values->GetNumberOfComponents() ||
      own->GetNumberOfTuples() < levels.Images[index]->GetNumberOfPoints())
    {
      why = "Block " + std::to_string(index) + " of the texture has " +
        std::to_string(own->GetNumberOfTuples()) + " scalars of type " +
        own->GetDataTypeAsString() + " and " + std::to_string(own->GetNumberOfComponents()) +
        " components; " + std::to_string(levels.Images[index]->GetNumberOfPoints()) + " of " +
        values->GetDataTypeAsString() + " and " + std::to_string(values->GetNumberOfComponents()) +
        ", as in block 0, were expected.";
      return false;
    }
  }
  return true;
}

} // namespace bravais
