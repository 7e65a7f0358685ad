// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCPlacement.h"

#include "BCCFit.h"
#include "ImageChecks.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace bravais
{

//------------------------------------------------------------------------------
bool ReadGrid(vtkInformation* info, ImageGrid& grid, std::string& why)
{
  std::fill_n(grid.Origin, 3, 0.0);
  std::fill_n(grid.Spacing, 3, 1.0);
  vtkMatrix3x3::Identity(grid.Direction);
  int* w = grid.Whole;
  std::ostringstream text;
  if (!info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    why = "The input says nothing of its extent; an image was expected.";
    return false;
  }
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), w);
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    info->Get(vtkDataObject::ORIGIN(), grid.Origin);
  }
  if (info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), grid.Spacing);
  }
  if (info->Has(vtkDataObject::DIRECTION()))
  {
    info->Get(vtkDataObject::DIRECTION(), grid.Direction);
  }
  if (w[0] >= w[1] || w[2] >= w[3] || w[4] >= w[5])
  {
    text << "The input's whole extent is " << w[0] << " .. " << w[1] << ", " << w[2] << " .. "
         << w[3] << ", " << w[4] << " .. " << w[5]
         << "; a volume with at least two points along each axis was expected.";
    why = text.str();
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double s = grid.Spacing[axis];
    if (!(s > 0.0) || !std::isfinite(s) || !std::isfinite(grid.Origin[axis]))
    {
      text << "The input's spacing and origin along "
           << "xyz"[axis] << " are " << s << " and " << grid.Origin[axis]
           << "; finite numbers were expected, and a positive spacing.";
      why = text.str();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool BCCPlacement::IsDecimation() const
{
  constexpr double more = 1.0 + 1e-9;
  const double* h = this->Step; // a / spacing of the image
  return 4.0 * h[0] * h[1] * h[2] > more || h[0] > more || h[1] > more || h[2] > more;
}

//------------------------------------------------------------------------------
void BCCPlacement::GetOrigin(const ImageGrid& grid, double origin[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = this->Start[axis] * grid.Spacing[axis];
  }
  vtkMatrix3x3::MultiplyPoint(grid.Direction, origin, origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] += grid.Origin[axis];
  }
}

//------------------------------------------------------------------------------
void BCCPlacement::GetMatrix(int coset, double matrix[16]) const
{
  std::fill_n(matrix, 16, 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inLayer = axis < 2;
    matrix[5 * axis] = inLayer ? 2.0 * this->Step[axis] : this->Step[axis];
    matrix[4 * axis + 3] =
      inLayer ? this->Start[axis] + coset * this->Step[axis] : this->Start[axis];
  }
  matrix[15] = 1.0;
}

//------------------------------------------------------------------------------
void BCCPlacement::GetImageExtent(
  const ImageGrid& grid, const int extent[6], const int margin[3], int imageExtent[6]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inLayer = axis < 2;
    const double first = (inLayer ? 2.0 : 1.0) * extent[2 * axis];
    const double last = inLayer ? 2.0 * extent[2 * axis + 1] + 1.0 : extent[2 * axis + 1];
    const double low = std::floor(this->Start[axis] + this->Step[axis] * first) - margin[axis];
    const double high = std::ceil(this->Start[axis] + this->Step[axis] * last) + margin[axis];
    const double least = grid.Whole[2 * axis];
    const double most = grid.Whole[2 * axis + 1];
    imageExtent[2 * axis] = static_cast<int>(std::clamp(low, least, most));
    imageExtent[2 * axis + 1] = static_cast<int>(std::clamp(high, least, most));
  }
}

//------------------------------------------------------------------------------
BCCPlacement PlaceSubset(const ImageGrid& grid)
{
  BCCPlacement placement;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inLayer = axis < 2;
    const int count = grid.Whole[2 * axis + 1] - grid.Whole[2 * axis] + 1;
    placement.Dimensions[axis] = inLayer ? count / 2 : count;
    placement.Spacing[axis] = inLayer ? 2.0 * grid.Spacing[axis] : grid.Spacing[axis];
    placement.Start[axis] = grid.Whole[2 * axis];
    placement.Step[axis] = 1.0;
  }
  return placement;
}

//------------------------------------------------------------------------------
bool CheckIsotropic(const int dimensions[3], double ratio, std::string& why)
{
  const int* n = dimensions;
  std::ostringstream text;
  if (n[0] == 0 && n[1] == 0 && n[2] == 0)
  {
    if (!(ratio > 0.0) || !std::isfinite(ratio))
    {
      text << "SampleRatio is " << ratio << "; a finite number above 0 was expected.";
    }
  }
  else if (n[0] < 1 || n[1] < 1 || n[2] < 2)
  {
    text << "Dimensions are " << n[0] << ", " << n[1] << ", " << n[2]
         << "; at least 1, 1, 2 were expected, or 0, 0, 0 to go by SampleRatio.";
  }
  else
  {
    const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
    return CheckExtent(whole, 1, why);
  }
  why = text.str();
  return why.empty();
}

//------------------------------------------------------------------------------
bool PlaceIsotropic(const ImageGrid& grid, const int dimensions[3], double ratio,
  BCCPlacement& placement, std::string& why)
{
  if (!CheckIsotropic(dimensions, ratio, why))
  {
    return false;
  }
  glm::dvec3 edges;
  double count = ratio;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double steps = static_cast<double>(grid.Whole[2 * axis + 1]) - grid.Whole[2 * axis];
    edges[axis] = steps * grid.Spacing[axis];
    count *= steps + 1.0;
  }
  const glm::ivec3 n(dimensions[0], dimensions[1], dimensions[2]);
  const bool chosen = n != glm::ivec3(0);
  const std::optional<BCCFit> fit =
    chosen ? BCCFit{ n, FitBCCUnit(edges, n) } : FitBCC(edges, count);
  if (!fit)
  {
    std::ostringstream text;
    text << "SampleRatio is " << ratio
         << "; a number was expected that gives at least 1 x 1 x 2 points, and not too many.";
    why = text.str();
    return false;
  }
  const glm::dvec3 used = GetBCCEdges(fit->Dimensions) * fit->Unit;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double margin = std::max(0.0, 0.5 * (edges[axis] - used[axis]));
    placement.Dimensions[axis] = fit->Dimensions[axis];
    placement.Spacing[axis] = axis < 2 ? 2.0 * fit->Unit : fit->Unit;
    placement.Start[axis] = grid.Whole[2 * axis] + margin / grid.Spacing[axis];
    placement.Step[axis] = fit->Unit / grid.Spacing[axis];
  }
  return true;
}

} // namespace bravais
