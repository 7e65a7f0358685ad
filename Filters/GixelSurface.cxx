// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelSurface.h"

#include "GeometryImage.h"
#include "GixelNormals.h"
#include "SliceLoop.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <numeric>

namespace bravais
{

//------------------------------------------------------------------------------
GixelSurface::GixelSurface(vtkAlgorithm* self, vtkImageData* image, int level)
  : Self(self)
  , Image(image)
  , Points(image->GetPointData()->GetArray(GeometryImagePoints))
  , Level(image->GetDimensions()[0], image->GetDimensions()[1], level)
  , Begin(0)
  , End(Level.Rows.Count() - 1)
{
  this->FindUsed();
}

//------------------------------------------------------------------------------
template <class T>
GixelGrid<T> GixelSurface::GetGrid() const
{
  return { static_cast<const T*>(this->Points->GetVoidPointer(0)),
    this->Used.empty() ? nullptr : this->Used.data(), this->Level.Width, this->Level.Height };
}

//------------------------------------------------------------------------------
void GixelSurface::FindUsed()
{
  const GixelView gixels(this->Image);
  std::vector<unsigned char> used(static_cast<std::size_t>(gixels.GetNumberOfGixels()));
  vtkSMPTools::For(0, gixels.GetNumberOfGixels(), 4096,
    [&](vtkIdType from, vtkIdType to)
    {
      for (vtkIdType n = from; n < to; ++n)
      {
        used[static_cast<std::size_t>(n)] = gixels.IsUsed(n);
      }
    });
  if (std::find(used.begin(), used.end(), 0) != used.end())
  {
    this->Used = std::move(used);
  }
}

//------------------------------------------------------------------------------
void GixelSurface::SetPiece(int piece, int count)
{
  const std::int64_t rows = this->Level.Rows.Count() - 1;
  this->Begin = static_cast<int>(rows * piece / count);
  this->End = static_cast<int>(rows * (piece + 1) / count);
  this->Empty = this->Begin == this->End && (rows > 0 || piece > 0);
}

//------------------------------------------------------------------------------
bool GixelSurface::IsWholeImage() const
{
  return this->Used.empty() && !this->Empty && this->Begin == 0 &&
    this->End + 1 == this->Level.Height && this->Level.Columns.Count() == this->Level.Width;
}

//------------------------------------------------------------------------------
std::int64_t GixelSurface::GetId(std::int64_t gixel) const
{
  const std::int64_t n = gixel - std::int64_t{ this->Begin } * this->Level.Columns.Count();
  return this->Ids.empty() ? n : this->Ids[static_cast<std::size_t>(n)];
}

//------------------------------------------------------------------------------
std::int64_t GixelSurface::GetGixel(std::int64_t point) const
{
  return this->IsWholeImage() ? point : this->Gixels[static_cast<std::size_t>(point)];
}

//------------------------------------------------------------------------------
void GixelSurface::MakePoints(vtkPolyData* output)
{
  const int columns = this->Level.Columns.Count();
  vtkNew<vtkPointData> attributes; // of the image, without what only it needs
  attributes->ShallowCopy(this->Image->GetPointData());
  attributes->RemoveArray(this->Points->GetName());
  attributes->RemoveArray(GeometryImageDefined);
  vtkNew<vtkPoints> points;
  if (this->IsWholeImage())
  {
    points->SetData(this->Points);
    output->GetPointData()->PassData(attributes);
    output->SetPoints(points);
    return;
  }
  for (int row = this->GetFirstPointRow(); row <= this->GetLastPointRow(); ++row)
  {
    const std::int64_t start = std::int64_t{ this->Level.Rows[row] } * this->Level.Width;
    for (int column = 0; column < columns; ++column)
    {
      const std::int64_t gixel = start + this->Level.Columns[column];
      const bool used = this->Used.empty() || this->Used[static_cast<std::size_t>(gixel)];
      if (!this->Used.empty())
      {
        this->Ids.push_back(used ? static_cast<std::int64_t>(this->Gixels.size()) : -1);
      }
      if (used)
      {
        this->Gixels.push_back(gixel);
      }
    }
  }
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(static_cast<vtkIdType>(this->Gixels.size()));
  std::copy(this->Gixels.begin(), this->Gixels.end(), from->GetPointer(0));
  const auto take = [&](vtkAbstractArray* array, vtkAbstractArray* taken)
  {
    taken->SetName(array->GetName());
    taken->SetNumberOfComponents(array->GetNumberOfComponents());
    taken->CopyComponentNames(array);
    taken->SetNumberOfTuples(from->GetNumberOfIds());
    array->GetTuples(from, taken);
  };
  points->SetDataType(this->Points->GetDataType());
  take(this->Points, points->GetData());
  output->SetPoints(points);
  for (int n = 0; n < attributes->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(n);
    auto taken = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    take(array, taken);
    const int index = output->GetPointData()->AddArray(taken);
    const int attribute = attributes->IsArrayAnAttribute(n);
    if (attribute >= 0)
    {
      output->GetPointData()->SetActiveAttribute(index, attribute);
    }
  }
}

//------------------------------------------------------------------------------
template <class T>
bool GixelSurface::ClassifyCells(const unsigned char* mask, std::vector<std::int64_t>& counts)
{
  const auto columns = static_cast<std::size_t>(this->Level.Columns.Count() - 1);
  const GixelGrid<T> grid = this->GetGrid<T>();
  return ForEachSlice(
    this->Self, this->Begin, this->End - 1,
    [&](int row)
    {
      const auto n = static_cast<std::size_t>(row - this->Begin);
      counts[n] =
        ClassifyGixelCells(grid, this->Level, mask, row, this->Cells.data() + n * columns);
    },
    0.0, 0.3);
}

//------------------------------------------------------------------------------
template <class Array>
bool GixelSurface::WriteTriangles(vtkPolyData* output, const std::vector<std::int64_t>& counts)
{
  using Id = typename Array::ValueType;
  std::vector<std::int64_t> begin(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), begin.begin() + 1);
  vtkNew<Array> offsets;
  vtkNew<Array> connectivity;
  offsets->SetNumberOfValues(begin.back() + 1);
  connectivity->SetNumberOfValues(3 * begin.back());
  offsets->SetValue(begin.back(), static_cast<Id>(3 * begin.back()));
  const std::int64_t columns = this->Level.Columns.Count();
  const auto work = [&](int row)
  {
    const auto n = static_cast<std::size_t>(row - this->Begin);
    const unsigned char* cells = this->Cells.data() + n * static_cast<std::size_t>(columns - 1);
    std::int64_t triangle = begin[n];
    for (std::int64_t column = 0; column + 1 < columns; ++column)
    {
      for (const unsigned which : { FirstTriangle, SecondTriangle })
      {
        if (cells[column] & which)
        {
          const GixelTriangle corners = GetGixelTriangle(row * columns + column, columns,
            (cells[column] & SplitBC) != 0, which == SecondTriangle);
          Id* ids = connectivity->GetPointer(3 * triangle);
          ids[0] = static_cast<Id>(this->GetId(corners[0]));
          ids[1] = static_cast<Id>(this->GetId(corners[1]));
          ids[2] = static_cast<Id>(this->GetId(corners[2]));
          offsets->GetPointer(0)[triangle] = static_cast<Id>(3 * triangle);
          ++triangle;
        }
      }
    }
  };
  if (!ForEachSlice(this->Self, this->Begin, this->End - 1, work, 0.3, 0.6))
  {
    return false;
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  output->SetPolys(polygons);
  return true;
}

//------------------------------------------------------------------------------
bool GixelSurface::WriteStrips(vtkPolyData* output)
{
  const std::int64_t columns = this->Level.Columns.Count();
  const auto rows = static_cast<std::size_t>(this->End - this->Begin);
  std::vector<std::vector<std::int64_t>> lengths(rows);
  std::vector<std::vector<std::int64_t>> gixels(rows);
  const auto work = [&](int row)
  {
    const auto n = static_cast<std::size_t>(row - this->Begin);
    AppendGixelStrips(this->Cells.data() + n * static_cast<std::size_t>(columns - 1), columns, row,
      lengths[n], gixels[n]);
  };
  if (!ForEachSlice(this->Self, this->Begin, this->End - 1, work, 0.3, 0.6))
  {
    return false;
  }
  vtkNew<vtkCellArray> strips;
  for (std::size_t n = 0; n < rows; ++n)
  {
    auto gixel = gixels[n].begin();
    for (const std::int64_t length : lengths[n])
    {
      strips->InsertNextCell(static_cast<int>(length));
      for (std::int64_t corner = 0; corner < length; ++corner, ++gixel)
      {
        strips->InsertCellPoint(this->GetId(*gixel));
      }
    }
  }
  output->SetStrips(strips);
  return true;
}

//------------------------------------------------------------------------------
bool GixelSurface::MakeTriangles(vtkPolyData* output, const unsigned char* mask, bool strips)
{
  if (this->Begin == this->End || this->Level.Columns.Count() < 2)
  {
    return true;
  }
  std::vector<unsigned char> levelMask;
  if (mask && this->Level.Count() < this->Image->GetNumberOfPoints())
  {
    levelMask = DownSampleMask(mask, this->Level);
    mask = levelMask.data();
  }
  const auto rows = static_cast<std::size_t>(this->End - this->Begin);
  std::vector<std::int64_t> counts(rows);
  this->Cells.resize(rows * static_cast<std::size_t>(this->Level.Columns.Count() - 1));
  const bool classified = this->Points->GetDataType() == VTK_DOUBLE
    ? this->ClassifyCells<double>(mask, counts)
    : this->ClassifyCells<float>(mask, counts);
  if (!classified)
  {
    return false;
  }
  if (strips)
  {
    return this->WriteStrips(output);
  }
  const bool small = this->Level.Count() < VTK_INT_MAX / 6; // connectivity fits 32 bits
  return small ? this->WriteTriangles<vtkTypeInt32Array>(output, counts)
               : this->WriteTriangles<vtkTypeInt64Array>(output, counts);
}

//------------------------------------------------------------------------------
template <class T>
bool GixelSurface::ComputeNormals(float* normals)
{
  const GixelGrid<T> grid = this->GetGrid<T>();
  const GixelSeams<T> seams(grid);
  const int columns = this->Level.Columns.Count();
  const auto work = [&](int row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const int x = this->Level.Columns[column];
      const int y = this->Level.Rows[row];
      const std::int64_t id = this->GetId(std::int64_t{ row } * columns + column);
      if (id >= 0)
      {
        const glm::dvec3 normal = GetGixelNormal(grid, seams, x, y);
        for (int axis = 0; axis < 3; ++axis)
        {
          normals[3 * id + axis] = static_cast<float>(normal[axis]);
        }
      }
    }
  };
  return ForEachSlice(
    this->Self, this->GetFirstPointRow(), this->GetLastPointRow(), work, 0.6, 1.0);
}

//------------------------------------------------------------------------------
bool GixelSurface::MakeNormals(vtkPolyData* output)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(output->GetNumberOfPoints());
  float* values = normals->GetPointer(0);
  output->GetPointData()->SetNormals(normals);
  return this->Points->GetDataType() == VTK_DOUBLE ? this->ComputeNormals<double>(values)
                                                   : this->ComputeNormals<float>(values);
}

//------------------------------------------------------------------------------
void GixelSurface::MakeTextureCoordinates(vtkPolyData* output)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(output->GetNumberOfPoints());
  const std::int64_t width = this->Level.Width;
  const double x = 1.0 / static_cast<double>(std::max<std::int64_t>(width - 1, 1));
  const double y = 1.0 / std::max(this->Level.Height - 1, 1);
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const std::int64_t gixel = this->GetGixel(point);
    coordinates->SetTypedComponent(
      point, 0, static_cast<float>(static_cast<double>(gixel % width) * x));
    coordinates->SetTypedComponent(
      point, 1, static_cast<float>(static_cast<double>(gixel / width) * y));
  }
  output->GetPointData()->SetTCoords(coordinates);
}

} // namespace bravais
