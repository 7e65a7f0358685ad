// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCSubset.h"

#include "BCCLattice.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cstddef>
#include <cstring>

namespace bravais
{
namespace
{

/// Copies every second tuple. The common sizes are spelt out, so that copying one is one move.
void CopyRow(const char* in, char* out, std::size_t size, int count)
{
  const auto copy = [&](auto bytes)
  {
    for (int i = 0; i < count; ++i)
    {
      std::memcpy(out + i * bytes, in + 2 * i * bytes, bytes);
    }
  };
  switch (size)
  {
    case 1:
      return copy(std::integral_constant<std::size_t, 1>());
    case 2:
      return copy(std::integral_constant<std::size_t, 2>());
    case 4:
      return copy(std::integral_constant<std::size_t, 4>());
    case 8:
      return copy(std::integral_constant<std::size_t, 8>());
    default:
      return copy(size);
  }
}

bool HasPlainMemory(vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  return numbers && numbers->HasStandardMemoryLayout() && numbers->GetDataType() != VTK_BIT;
}

} // namespace

//------------------------------------------------------------------------------
bool CopySubset(vtkAlgorithm* self, vtkImageData* input, const int first[3], vtkImageData* output)
{
  vtkPointData* inData = input->GetPointData();
  vtkPointData* outData = output->GetPointData();
  const vtkIdType points = output->GetNumberOfPoints();
  outData->CopyAllOn();
  outData->CopyAllocate(inData, points);
  outData->SetNumberOfTuples(points);

  int e[6];
  output->GetExtent(e);
  const int count = e[1] - e[0] + 1;
  // Calls row(from, to, count) for each row of a layer, with the ids of its first points.
  const auto forEachRow = [&](int k, const auto& row)
  {
    const int odd = BCCLattice::GetCoset(k);
    for (int j = e[2]; j <= e[3]; ++j)
    {
      int from[3] = { first[0] + 2 * e[0] + odd, first[1] + 2 * j + odd, first[2] + k };
      int to[3] = { e[0], j, k };
      row(input->ComputePointId(from), output->ComputePointId(to));
    }
  };

  const int arrays = inData->GetNumberOfArrays();
  for (int a = 0; a < arrays; ++a)
  {
    vtkAbstractArray* in = inData->GetAbstractArray(a);
    vtkAbstractArray* out = outData->GetAbstractArray(a);
    const double begin = static_cast<double>(a) / arrays;
    const double end = static_cast<double>(a + 1) / arrays;
    bool finished;
    if (HasPlainMemory(in) && HasPlainMemory(out))
    {
      const std::size_t size =
        static_cast<std::size_t>(in->GetDataTypeSize()) * in->GetNumberOfComponents();
      const auto* source = static_cast<const char*>(in->GetVoidPointer(0));
      auto* target = static_cast<char*>(out->GetVoidPointer(0));
      const auto row = [&](vtkIdType from, vtkIdType to)
      { CopyRow(source + from * size, target + to * size, size, count); };
      finished = ForEachSlice(
        self, e[4], e[5], [&](int k) { forEachRow(k, row); }, begin, end);
    }
    else // strings, bits and computed arrays: not one of them lets threads write side by side
    {
      const auto row = [&](vtkIdType from, vtkIdType to)
      {
        for (int i = 0; i < count; ++i)
        {
          out->SetTuple(to + i, from + 2 * i, in);
        }
      };
      finished = ForEachSliceInOrder(
        self, e[4], e[5], [&](int k) { forEachRow(k, row); }, begin, end);
    }
    if (!finished)
    {
      return false;
    }
  }
  return true;
}

} // namespace bravais
