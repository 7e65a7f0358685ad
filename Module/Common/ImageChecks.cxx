// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageChecks.h"

#include "vtkAbstractArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include "vtksys/SystemInformation.hxx"

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <type_traits>

namespace bravais
{

namespace
{

std::string Join(const double v[3])
{
  std::ostringstream text;
  text << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return text.str();
}

/// Total memory in bytes. Asked once, since it does not change.
double GetPhysicalMemory()
{
  static const double bytes = []
  {
    vtksys::SystemInformation system;
    system.RunMemoryCheck();
    return static_cast<double>(system.GetTotalPhysicalMemory()) * 1024.0 * 1024.0;
  }();
  return bytes;
}

} // namespace

//------------------------------------------------------------------------------
std::string JoinDimensions(const int extent[6])
{
  std::ostringstream text;
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis ? " x " : "") << std::int64_t{ extent[2 * axis + 1] } - extent[2 * axis] + 1;
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool IsNumberType(int type)
{
  switch (type)
  {
    vtkTemplateMacro(return std::is_arithmetic_v<VTK_TT>);
  }
  return false;
}

//------------------------------------------------------------------------------
bool CheckPlacement(const double origin[3], const double spacing[3], std::string& why)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(spacing[axis] > 0.0) || !std::isfinite(spacing[axis]))
    {
      why = "The input's spacing is " + Join(spacing) + "; it has to be positive and finite.";
      return false;
    }
    if (!std::isfinite(origin[axis]))
    {
      why = "The input's origin is " + Join(origin) + "; it has to be finite.";
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool CheckPointArrays(vtkDataSet* data, std::string& why)
{
  vtkPointData* arrays = data->GetPointData();
  for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(n);
    if (array->GetNumberOfTuples() < data->GetNumberOfPoints())
    {
      why = std::string("The input's point array '") + (array->GetName() ? array->GetName() : "") +
        "' has " + std::to_string(array->GetNumberOfTuples()) + " tuples; one for each of " +
        std::to_string(data->GetNumberOfPoints()) + " points was expected.";
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool CheckExtent(const int extent[6], int bytesPerPoint, std::string& why)
{
  std::int64_t count = bytesPerPoint;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t first = extent[2 * axis];
    const std::int64_t last = extent[2 * axis + 1];
    constexpr std::int64_t limit = std::numeric_limits<int>::max() / 2;
    if (first > last)
    {
      why = "The dimensions are " + JoinDimensions(extent) + "; each has to be at least 1.";
      return false;
    }
    if (first < -limit || last > limit - 1)
    {
      why = "The dimensions are " + JoinDimensions(extent) + "; indices have to stay below " +
        std::to_string(limit) + ".";
      return false;
    }
    if (count > std::numeric_limits<std::int64_t>::max() / (last - first + 1))
    {
      why = "The dimensions are " + JoinDimensions(extent) + ", more points of " +
        std::to_string(bytesPerPoint) + " bytes than can be counted.";
      return false;
    }
    count *= last - first + 1;
  }
  return true;
}

//------------------------------------------------------------------------------
bool CheckMemory(const int extent[6], int bytesPerPoint, std::string& why)
{
  if (!CheckExtent(extent, bytesPerPoint, why))
  {
    return false;
  }
  double bytes = bytesPerPoint;
  for (int axis = 0; axis < 3; ++axis)
  {
    bytes *= extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  const double memory = GetPhysicalMemory();
  if (memory > 0.0 && bytes > memory)
  {
    std::ostringstream text;
    text << "The dimensions are " << JoinDimensions(extent) << ", which take " << bytes
         << " bytes; the machine has " << memory << ".";
    why = text.str();
    return false;
  }
  return true;
}

} // namespace bravais
