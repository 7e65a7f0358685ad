// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1ImageToPolyData.h"

#include "PieceRequest.h"
#include "Rank1Image.h"
#include "Rank1Polygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <numeric>

vtkStandardNewMacro(vtkRank1ImageToPolyData);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The picture's plane in the world.
class Plane
{
public:
  Plane(const bravais::Rank1Image& image, vtkImageData* data)
  {
    double inverse[9];
    std::copy_n(image.Domain, 4, this->Domain);
    std::copy_n(data->GetDirectionMatrix()->GetData(), 9, this->Direction);
    vtkMatrix3x3::Invert(this->Direction, inverse);
    vtkMatrix3x3::MultiplyPoint(inverse, data->GetOrigin(), this->Local);
  }

  /// The point at a position in units of the picture.
  void Set(vtkPoints* points, vtkIdType id, const glm::dvec2& position) const
  {
    // Whole at both ends: the border is where the domain says.
    const double* d = this->Domain;
    const double x[3] = { d[0] * (1.0 - position.x) + d[1] * position.x,
      d[2] * (1.0 - position.y) + d[3] * position.y, this->Local[2] };
    double world[3];
    vtkMatrix3x3::MultiplyPoint(this->Direction, x, world);
    points->SetPoint(id, world);
  }

private:
  double Domain[4];
  double Direction[9];
  double Local[3];
};

vtkSmartPointer<vtkDataArray> MakeValues(vtkDataArray* texels, vtkIdType count)
{
  vtkSmartPointer<vtkDataArray> values;
  values.TakeReference(vtkDataArray::CreateDataArray(texels->GetDataType()));
  values->SetName(texels->GetName());
  values->SetNumberOfComponents(texels->GetNumberOfComponents());
  values->SetNumberOfTuples(count);
  return values;
}

/// Points and values of some texels.
void AddTexels(const bravais::Rank1Cells& cells, const Plane& plane, vtkDataArray* source,
  const std::vector<vtkIdType>& texels, vtkPoints* points, vtkDataArray* values)
{
  for (vtkIdType id = 0; id < static_cast<vtkIdType>(texels.size()); ++id)
  {
    plane.Set(points, id, cells.GetPoint(texels[id]));
    values->SetTuple(id, texels[id], source);
  }
}

/// Vertices of cells, and the cells' values.
void FillCells(const std::vector<bravais::Rank1Polygons>& runs, const Plane& plane,
  vtkDataArray* source, vtkPolyData* output)
{
  const std::vector<vtkIdType> counts = bravais::CountRank1Vertices(runs);
  output->GetPoints()->SetNumberOfPoints(counts.back());
  vtkIdType id = 0;
  vtkIdType polygons = 0;
  for (const bravais::Rank1Polygons& run : runs)
  {
    polygons += static_cast<vtkIdType>(run.Texels.size());
    for (const bravais::Rank1Polygons::Vertex& vertex : run.Vertices)
    {
      plane.Set(output->GetPoints(), id++, vertex.Position);
    }
  }
  const vtkSmartPointer<vtkDataArray> values = MakeValues(source, polygons);
  vtkIdType cell = 0;
  for (const bravais::Rank1Polygons& run : runs)
  {
    for (const vtkIdType texel : run.Texels)
    {
      values->SetTuple(cell++, texel, source);
    }
  }
  vtkNew<vtkCellArray> cells;
  bravais::FillRank1Polygons(
    runs, [](vtkIdType texel) { return texel; }, 0, cells);
  output->SetPolys(cells);
  output->GetCellData()->SetScalars(values);
}

/// Texels that triangles have for vertices, then the ends of those that are cut.
void FillTriangles(const std::vector<bravais::Rank1Polygons>& runs,
  const bravais::Rank1Cells& cells, const Plane& plane, vtkDataArray* source, vtkPolyData* output)
{
  std::vector<vtkIdType> texels;
  for (const bravais::Rank1Polygons& run : runs)
  {
    std::copy_if(run.Corners.begin(), run.Corners.end(), std::back_inserter(texels),
      [](vtkIdType corner) { return corner >= 0; });
  }
  std::sort(texels.begin(), texels.end());
  texels.erase(std::unique(texels.begin(), texels.end()), texels.end());
  const auto first = static_cast<vtkIdType>(texels.size());
  const vtkIdType count = first + bravais::CountRank1Vertices(runs).back();
  const vtkSmartPointer<vtkDataArray> values = MakeValues(source, count);
  output->GetPoints()->SetNumberOfPoints(count);
  AddTexels(cells, plane, source, texels, output->GetPoints(), values);
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  vtkIdType id = first;
  for (const bravais::Rank1Polygons& run : runs)
  {
    for (const bravais::Rank1Polygons::Vertex& vertex : run.Vertices)
    {
      plane.Set(output->GetPoints(), id, vertex.Position);
      double weights[3];
      for (int i = 0; i < 3; ++i)
      {
        corners->SetId(i, vertex.Texels[i]);
        weights[i] = vertex.Barycentric[i];
      }
      values->InterpolateTuple(id++, corners, source, weights);
    }
  }
  const auto place = [&](vtkIdType texel) -> vtkIdType
  { return std::lower_bound(texels.begin(), texels.end(), texel) - texels.begin(); };
  vtkNew<vtkCellArray> triangles;
  bravais::FillRank1Polygons(runs, place, first, triangles);
  output->SetPolys(triangles);
  output->GetPointData()->SetScalars(values);
}

/// A vertex for each texel of a range.
void FillPoints(vtkIdType from, vtkIdType to, const bravais::Rank1Cells& cells, const Plane& plane,
  vtkDataArray* source, vtkPolyData* output)
{
  std::vector<vtkIdType> texels(to - from);
  std::iota(texels.begin(), texels.end(), from);
  const vtkSmartPointer<vtkDataArray> values = MakeValues(source, to - from);
  output->GetPoints()->SetNumberOfPoints(to - from);
  AddTexels(cells, plane, source, texels, output->GetPoints(), values);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType id = 0; id < to - from; ++id)
  {
    vertices->InsertNextCell(1, &id);
  }
  output->SetVerts(vertices);
  output->GetPointData()->SetScalars(values);
}

} // namespace

//------------------------------------------------------------------------------
const char* vtkRank1ImageToPolyData::GetShapeAsString()
{
  constexpr const char* names[] = { "VoronoiCells", "DelaunayTriangles", "Points" };
  return names[this->Shape];
}

//------------------------------------------------------------------------------
int vtkRank1ImageToPolyData::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageToPolyData::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageToPolyData::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  bravais::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1ImageToPolyData::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* out = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(out);
  std::string why;
  const auto image = bravais::ReadRank1Image(input, why);
  if (!image)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  for (const char* mark : { "Lattice", "Rank1.Generator", "Rank1.Domain" })
  {
    output->GetFieldData()->RemoveArray(mark); // passed from the input, but not true of it
  }
  const bravais::Rank1Cells cells(image->Lattice, image->Tiles[0], image->Tiles[1]);
  const Plane plane(*image, input);
  // Of numbered pieces each has its share of the texels, in order.
  const vtkIdType texels = cells.GetNumberOfTexels();
  const vtkIdType pieces = std::max(1, Pipeline::GetUpdateNumberOfPieces(out));
  const vtkIdType piece = Pipeline::GetUpdatePiece(out);
  const vtkIdType from = texels / pieces * piece + std::min(piece, texels % pieces);
  const vtkIdType to = from + texels / pieces + (piece < texels % pieces ? 1 : 0);
  constexpr double half = 0.5;
  this->UpdateProgress(0.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  output->SetPoints(points);
  if (this->Shape == Points)
  {
    FillPoints(from, to, cells, plane, image->Texels, output);
  }
  else
  {
    const auto runs = this->Shape == VoronoiCells
      ? bravais::FindRank1VoronoiCells(this, cells, from, to, half)
      : bravais::FindRank1Triangles(this, cells, from, to, half);
    if (!this->GetAbortExecute() && this->Shape == VoronoiCells)
    {
      FillCells(runs, plane, image->Texels, output);
    }
    else if (!this->GetAbortExecute())
    {
      FillTriangles(runs, cells, plane, image->Texels, output);
    }
  }
  if (this->GetAbortExecute())
  {
    output->Initialize();
    return 1;
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1ImageToPolyData::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->GetShapeAsString() << "\n";
}
