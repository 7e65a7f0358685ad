// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBayerPattern.h"

#include "BayerMeasures.h"
#include "BayerPattern.h"
#include "ImageChecks.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkBayerPattern);

namespace
{

// What a cell takes while an array is made, the array included.
constexpr int BytesPerRank = 3 * 8;
constexpr int BytesPerDistance = 8 + 8 + 24;
constexpr int BytesPerPower = 8 + 8 + 8 + 8 + 16;

template <class T>
void Copy(const std::vector<std::int64_t>& numbers, T* array)
{
  array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  std::transform(numbers.begin(), numbers.end(), array->GetPointer(0),
    [](std::int64_t number) { return static_cast<typename T::ValueType>(number); });
}

void Copy(const std::vector<double>& numbers, vtkDoubleArray* array)
{
  array->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array->GetPointer(0));
}

/// Whether a pattern's cells, of so many bytes, fit the machine's memory.
bool CheckCells(const bravais::BayerPattern& pattern, int bytesPerCell, std::string& why)
{
  const int last = static_cast<int>(pattern.GetSize() - 1);
  const int extent[6] = { 0, last, 0, last, 0, pattern.GetDimension() == 3 ? last : 0 };
  return bravais::CheckMemory(extent, bytesPerCell, why);
}

}

//------------------------------------------------------------------------------
const char* vtkBayerPattern::GetBaseOrderAsString()
{
  return this->BaseOrder == FCC ? "FCC" : "BCC";
}

//------------------------------------------------------------------------------
template <class Function>
bool vtkBayerPattern::Fill(
  int dimension, int log2Size, vtkDataArray* array, int bytesPerCell, const Function& function)
{
  if (!array)
  {
    vtkErrorMacro("There is no array; one to write to was expected.");
    return false;
  }
  array->Initialize();
  array->SetNumberOfComponents(1);
  if (dimension != 2 && dimension != 3)
  {
    vtkErrorMacro("The dimension is " << dimension << "; 2 or 3 was expected.");
    return false;
  }
  const auto pattern = bravais::BayerPattern::Create(dimension, log2Size,
    this->BaseOrder == FCC ? bravais::BayerPattern::Base::FCC : bravais::BayerPattern::Base::BCC);
  if (!pattern)
  {
    vtkErrorMacro("The log2 size is "
      << log2Size << "; in " << dimension << " dimensions it has to be from 0 to "
      << bravais::BayerPattern::GetMaximumLog2Size(dimension) << ".");
    return false;
  }
  std::string why;
  if (!CheckCells(*pattern, bytesPerCell, why))
  {
    vtkErrorMacro("The log2 size is " << log2Size << ". " << why);
    return false;
  }
  function(*pattern);
  return true;
}

//------------------------------------------------------------------------------
bool vtkBayerPattern::GetThresholds(int dimension, int log2Size, vtkIdTypeArray* ranks)
{
  return this->Fill(dimension, log2Size, ranks, BytesPerRank,
    [=](const bravais::BayerPattern& pattern) { Copy(bravais::GetThresholds(pattern), ranks); });
}

//------------------------------------------------------------------------------
bool vtkBayerPattern::GetOrder(int dimension, int log2Size, vtkIdTypeArray* cells)
{
  return this->Fill(dimension, log2Size, cells, BytesPerRank,
    [=](const bravais::BayerPattern& pattern) { Copy(bravais::GetOrder(pattern), cells); });
}

//------------------------------------------------------------------------------
bool vtkBayerPattern::GetMinimumDistances(int dimension, int log2Size, vtkDoubleArray* distances)
{
  return this->Fill(dimension, log2Size, distances, BytesPerDistance,
    [=](const bravais::BayerPattern& pattern)
    {
      Copy(bravais::GetSquaredMinimumDistances(pattern), distances);
      double* first = distances->GetPointer(0);
      std::transform(first, first + distances->GetNumberOfValues(), first,
        [](double squared) { return std::sqrt(squared); });
    });
}

//------------------------------------------------------------------------------
bool vtkBayerPattern::GetPowerSpectrum(
  int dimension, int log2Size, vtkIdType count, vtkDoubleArray* power)
{
  vtkIdType cells = 0;
  const bool filled = this->Fill(dimension, log2Size, power, BytesPerPower,
    [&](const bravais::BayerPattern& pattern)
    {
      cells = pattern.GetNumberOfCells();
      if (count >= 0 && count <= cells)
      {
        Copy(bravais::GetPrefixSpectrum(pattern, count), power);
      }
    });
  if (filled && (count < 0 || count > cells))
  {
    vtkErrorMacro("The count is " << count << "; from 0 to " << cells << " cells were expected.");
    return false;
  }
  return filled;
}

//------------------------------------------------------------------------------
bool vtkBayerPattern::GetPowerSpectrum(int dimension, int log2Size, vtkDoubleArray* power)
{
  return this->Fill(dimension, log2Size, power, BytesPerPower,
    [=](const bravais::BayerPattern& pattern)
    { Copy(bravais::GetThresholdSpectrum(pattern), power); });
}

//------------------------------------------------------------------------------
void vtkBayerPattern::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BaseOrder: " << this->GetBaseOrderAsString() << "\n";
}
