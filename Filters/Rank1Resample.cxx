// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Resample.h"

#include "ImageChecks.h"
#include "LatticeTag.h"
#include "Rank1Image.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace bravais
{

namespace
{

constexpr int MostPoints = VTK_INT_MAX / 2; ///< of a tile

/// Texels of one tile in runs, each of them work for one thread.
struct Runs
{
  std::int64_t First;
  std::int64_t Last;
  std::int64_t Length;
  int PerTile;

  Runs(int first, int last, int tiles, double cost)
    : First(first)
    , Last(std::int64_t{ last } + 1)
  {
    constexpr double mostTexels = 16384.0;
    constexpr double mostPixels = 262144.0;
    constexpr std::int64_t mostRuns = 1 << 24;
    const std::int64_t count = this->Last - this->First;
    this->Length = static_cast<std::int64_t>(std::min(mostTexels, mostPixels / cost)) + 1;
    this->Length = std::max(this->Length, count * tiles / mostRuns + 1);
    this->PerTile = static_cast<int>((count - 1) / this->Length + 1);
  }
};

template <class T>
bool Resample(vtkAlgorithm* self, const Rank1Resampler& resampler, const T* pixels,
  const int extent[6], int components, T* texels, double begin, double end)
{
  const int columns = extent[3] - extent[2] + 1;
  const int tiles = columns * (extent[5] - extent[4] + 1);
  const Runs runs(extent[0], extent[1], tiles, resampler.GetPixelsPerTexel());
  const auto work = [&](int index)
  {
    const int tile = index / runs.PerTile;
    const std::int64_t from = runs.First + index % runs.PerTile * runs.Length;
    const std::int64_t to = std::min(from + runs.Length, runs.Last);
    const std::int64_t place = tile * (runs.Last - runs.First) + from - runs.First;
    resampler.Execute(pixels, components,
      { extent[2] + tile % columns, extent[4] + tile / columns }, from, to,
      texels + place * components);
  };
  return ForEachSlice(self, 0, tiles * runs.PerTile - 1, work, begin, end);
}

} // namespace

//------------------------------------------------------------------------------
std::optional<Rank1Picture> Rank1Picture::Create(const int extent[6], const double origin[3],
  const double spacing[3], const double direction[9], std::string& why)
{
  if (!CheckExtent(extent, 1, why) || !CheckPlacement(origin, spacing, why))
  {
    return std::nullopt;
  }
  if (extent[4] != extent[5])
  {
    why = "The input's dimensions are " + JoinDimensions(extent) +
      "; a picture of one layer, nx x ny x 1, was expected.";
    return std::nullopt;
  }
  double inverse[9];
  double corner[3];
  vtkMatrix3x3::Invert(direction, inverse);
  vtkMatrix3x3::MultiplyPoint(inverse, origin, corner);
  Rank1Picture picture;
  for (int axis = 0; axis < 2; ++axis)
  {
    picture.Pixels[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    picture.Domain[2 * axis] = corner[axis] + spacing[axis] * (extent[2 * axis] - 0.5);
    picture.Domain[2 * axis + 1] = corner[axis] + spacing[axis] * (extent[2 * axis + 1] + 0.5);
  }
  picture.Z = corner[2] + spacing[2] * extent[4];
  return picture;
}

//------------------------------------------------------------------------------
bool CheckRank1Parameters(const Rank1ResampleParameters& parameters, std::string& why)
{
  std::ostringstream text;
  const int* tiles = parameters.Tiles;
  const vtkIdType* g = parameters.Generator;
  const vtkIdType n = parameters.NumberOfPoints;
  constexpr int most = 1 << 20;
  constexpr int mostTiles = 1 << 28;
  if (tiles[0] < 1 || tiles[1] < 1 || tiles[0] > most || tiles[1] > most ||
    std::int64_t{ tiles[0] } * tiles[1] > mostTiles)
  {
    text << "Tiles are " << tiles[0] << " x " << tiles[1] << "; 1 to " << most
         << " each way were expected, and at most " << mostTiles << " tiles.";
  }
  else if (n < 0 || n > MostPoints)
  {
    text << "NumberOfPoints is " << n << "; 1 to " << MostPoints
         << " were expected, or 0 for as many texels as pixels.";
  }
  else if (n > 0 && (g[0] != 0 || g[1] != 0) &&
    !Rank1Lattice::Create(n, g[0], g[1], glm::dvec2(1.0)))
  {
    text << ExplainRank1Lattice(n, g[0], g[1], 1.0, 1.0);
  }
  why = text.str();
  return why.empty();
}

//------------------------------------------------------------------------------
bool FindRank1Dimensions(const Rank1Picture& picture, const Rank1ResampleParameters& parameters,
  int dimensions[3], std::string& why)
{
  if (!CheckRank1Parameters(parameters, why))
  {
    return false;
  }
  const int* tiles = parameters.Tiles;
  const double pixels = static_cast<double>(picture.Pixels[0]) * picture.Pixels[1];
  const double tileCount = static_cast<double>(tiles[0]) * tiles[1];
  double n = static_cast<double>(parameters.NumberOfPoints);
  if (parameters.NumberOfPoints == 0)
  {
    n = std::max(1.0, std::floor(pixels / tileCount + 0.5));
  }
  if (n > MostPoints)
  {
    std::ostringstream text;
    text << "NumberOfPoints is 0, which stands for " << n << " texels for each of " << tiles[0]
         << " x " << tiles[1] << " tiles of a picture of " << pixels << " pixels; 1 to "
         << MostPoints << " were expected.";
    why = text.str();
    return false;
  }
  dimensions[0] = static_cast<int>(n);
  dimensions[1] = tiles[0];
  dimensions[2] = tiles[1];
  return true;
}

//------------------------------------------------------------------------------
std::optional<Rank1Lattice> FindRank1Lattice(
  const Rank1Picture& picture, const Rank1ResampleParameters& parameters, std::string& why)
{
  int dimensions[3];
  if (!FindRank1Dimensions(picture, parameters, dimensions, why))
  {
    return std::nullopt;
  }
  const glm::dvec2 size((picture.Domain[1] - picture.Domain[0]) / dimensions[1],
    (picture.Domain[3] - picture.Domain[2]) / dimensions[2]);
  const vtkIdType* g = parameters.Generator;
  const bool given = g[0] != 0 || g[1] != 0;
  const auto lattice = given ? Rank1Lattice::Create(dimensions[0], g[0], g[1], size)
                             : MaximizeMinimumDistance(dimensions[0], size, parameters.Layout);
  if (!lattice)
  {
    why = ExplainRank1Lattice(dimensions[0], given ? g[0] : 1, given ? g[1] : 1, size.x, size.y);
  }
  return lattice;
}

//------------------------------------------------------------------------------
bool CheckRank1Input(vtkImageData* image, std::string& why)
{
  if (!image)
  {
    why = "There is no input image; a picture was expected.";
    return false;
  }
  for (const char* tag : { Rank1Tag, BCCTag })
  {
    if (HasLatticeTag(image, tag))
    {
      why = std::string("The input is tagged as an image of the lattice ") + tag +
        "; a Cartesian picture was expected.";
      return false;
    }
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() < 1 ||
    scalars->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    why = "The input has no point scalars, or fewer than points.";
    return false;
  }
  if (!IsNumberType(scalars->GetDataType()))
  {
    why = std::string("The input's scalars are of type ") + scalars->GetDataTypeAsString() +
      "; numbers of 8 to 64 bits were expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool ResampleToRank1(vtkAlgorithm* self, const Rank1Picture& picture,
  const Rank1ResampleParameters& parameters, const Rank1Lattice& lattice, vtkDataArray* pixels,
  const int extent[6], vtkImageData* output, double begin, double end)
{
  const glm::ivec2 tiles(parameters.Tiles[0], parameters.Tiles[1]);
  const glm::ivec2 size(picture.Pixels[0], picture.Pixels[1]);
  const double texelsPerPixel = static_cast<double>(lattice.GetNumberOfPoints()) * tiles.x *
    tiles.y / (static_cast<double>(size.x) * size.y);
  const Rank1Filter filter =
    parameters.Filter.value_or(texelsPerPixel > 1.0 ? Rank1Filter::Bilinear : Rank1Filter::Box);
  const Rank1Resampler resampler(lattice, tiles, size, filter, parameters.Boundary);
  output->SetExtent(const_cast<int*>(extent));
  output->AllocateScalars(pixels->GetDataType(), pixels->GetNumberOfComponents());
  vtkDataArray* texels = output->GetPointData()->GetScalars();
  texels->SetName(pixels->GetName());
  TagRank1Image(output, lattice, picture.Domain);
  bool finished = false;
  switch (pixels->GetDataType())
  {
    vtkTemplateMacro(
      finished = Resample(self, resampler, static_cast<const VTK_TT*>(pixels->GetVoidPointer(0)),
        extent, pixels->GetNumberOfComponents(), static_cast<VTK_TT*>(texels->GetVoidPointer(0)),
        begin, end));
  }
  return finished;
}

} // namespace bravais
