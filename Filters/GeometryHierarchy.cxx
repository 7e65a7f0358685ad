// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeometryHierarchy.h"

#include "GeometryImage.h"
#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace bravais
{

namespace
{

/// When an image or what is read of it was last changed.
vtkMTimeType GetTime(vtkImageData* image)
{
  vtkMTimeType time = image->GetMTime();
  for (const char* name : { GeometryImagePoints, GeometryImageDefined })
  {
    vtkDataArray* array = image->GetPointData()->GetArray(name);
    time = std::max(time, array ? array->GetMTime() : 0);
  }
  return time;
}

/// The box of the used gixels; Low is above High if there is none. False if aborted.
bool GetBounds(vtkAlgorithm* self, const GixelView& view, double begin, double end, Box& bounds)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> rows(
    static_cast<std::size_t>(view.GetHeight()), Box{ glm::dvec3(infinity), glm::dvec3(-infinity) });
  const auto row = [&](int j)
  {
    Box box = rows[static_cast<std::size_t>(j)];
    for (vtkIdType gixel = j * view.GetWidth(); gixel < (j + 1) * view.GetWidth(); ++gixel)
    {
      if (view.IsUsed(gixel))
      {
        glm::dvec3 x;
        view.GetPoint(gixel, &x.x);
        box = { glm::min(box.Low, x), glm::max(box.High, x) };
      }
    }
    rows[static_cast<std::size_t>(j)] = box;
  };
  if (!ForEachSlice(self, 0, static_cast<int>(view.GetHeight()) - 1, row, begin, end))
  {
    return false;
  }
  bounds = rows[0];
  for (const Box& box : rows)
  {
    bounds = { glm::min(bounds.Low, box.Low), glm::max(bounds.High, box.High) };
  }
  return true;
}

bool MakeGrid(const GeometryHierarchy::Parameters& parameters, const GixelView& view,
  const Box& bounds, std::optional<CellGrid>& grid, std::string& why)
{
  if (!(bounds.Low.x <= bounds.High.x))
  {
    return true; // no gixel, no cells
  }
  const glm::dvec3 size = bounds.High - bounds.Low;
  if (!std::isfinite(size.x + size.y + size.z) && !CheckFinite(view, why))
  {
    return false;
  }
  const double* cube = parameters.RootCube;
  grid = cube[3] > 0.0
    ? CellGrid::Create(glm::dvec3(cube[0], cube[1], cube[2]), cube[3], parameters.MaximumDepth)
    : CellGrid::CreateRound(bounds, parameters.MaximumDepth);
  if (!grid)
  {
    std::ostringstream text;
    text << "RootCube is " << cube[0] << ", " << cube[1] << ", " << cube[2] << ", " << cube[3]
         << " and the gixels' box is " << size.x << " x " << size.y << " x " << size.z
         << "; cells of so many to the edge as 2^MaximumDepth were expected to have finite faces "
            "that double precision tells apart.";
    why = text.str();
  }
  return grid.has_value();
}

} // namespace

//------------------------------------------------------------------------------
bool GeometryHierarchy::Check(const Parameters& parameters, std::string& why)
{
  std::ostringstream text;
  const double* cube = parameters.RootCube;
  if (parameters.MaximumDepth < 0 || parameters.MaximumDepth > CellGrid::MaximumDepth)
  {
    text << "MaximumDepth is " << parameters.MaximumDepth << "; 0 to " << CellGrid::MaximumDepth
         << " were expected.";
  }
  else if (!(cube[3] >= 0.0) || !std::isfinite(cube[0] + cube[1] + cube[2] + cube[3]))
  {
    text << "RootCube is " << cube[0] << ", " << cube[1] << ", " << cube[2] << ", " << cube[3]
         << "; finite numbers and an edge of at least 0 were expected.";
  }
  why = text.str();
  return why.empty();
}

//------------------------------------------------------------------------------
bool GeometryHierarchy::Parameters::operator==(const Parameters& other) const
{
  return this->MaximumDepth == other.MaximumDepth && this->Encoding == other.Encoding &&
    this->StoreInternalMasks == other.StoreInternalMasks &&
    std::equal(this->RootCube, this->RootCube + 4, other.RootCube);
}

//------------------------------------------------------------------------------
bool GeometryHierarchy::IsOf(vtkImageData* image, const Parameters& parameters) const
{
  return this->Made && *this->Made == parameters && this->Image == image &&
    this->ImageTime == GetTime(image);
}

//------------------------------------------------------------------------------
void GeometryHierarchy::Clear()
{
  *this = GeometryHierarchy();
}

//------------------------------------------------------------------------------
bool GeometryHierarchy::Build(vtkAlgorithm* self, vtkImageData* image, const Parameters& parameters,
  double begin, double end, std::string& why)
{
  this->Clear();
  why.clear();
  if (!Check(parameters, why))
  {
    return false;
  }
  const GixelView view(image);
  if (view.GetNumberOfGixels() >= vtkIdType{ CellGrid::NoCell })
  {
    why = "The image has " + std::to_string(view.GetNumberOfGixels()) + " gixels; fewer than " +
      std::to_string(CellGrid::NoCell) + " were expected.";
    return false;
  }
  Box bounds;
  const auto at = [=](double share) { return begin + share * (end - begin); };
  if (!GetBounds(self, view, begin, at(0.2), bounds) ||
    !MakeGrid(parameters, view, bounds, this->Grid, why))
  {
    this->Clear();
    return false;
  }
  std::vector<std::uint32_t> codes(
    static_cast<std::size_t>(view.GetNumberOfGixels()), CellGrid::NoCell);
  const auto row = [&](int j)
  {
    for (vtkIdType gixel = j * view.GetWidth(); gixel < (j + 1) * view.GetWidth(); ++gixel)
    {
      if (view.IsUsed(gixel))
      {
        glm::dvec3 x;
        view.GetPoint(gixel, &x.x);
        codes[static_cast<std::size_t>(gixel)] = this->Grid->GetCode(x);
      }
    }
  };
  const int rows = static_cast<int>(view.GetHeight());
  if (this->Grid && !ForEachSlice(self, 0, rows - 1, row, at(0.2), at(0.5)))
  {
    this->Clear();
    return false;
  }
  this->Tree = GixelOctree(codes, parameters.MaximumDepth);
  this->Masks =
    MaskStore(this->Tree, codes.size(), parameters.Encoding, parameters.StoreInternalMasks);
  const auto encode = [&](int depth) { this->Masks.Encode(this->Tree, depth); };
  if (!ForEachSlice(self, 0, parameters.MaximumDepth, encode, at(0.7), end))
  {
    this->Clear();
    return false;
  }
  this->Gixels = view.GetNumberOfGixels();
  this->Made = parameters;
  this->Image = image;
  this->ImageTime = GetTime(image);
  return true;
}

} // namespace bravais
