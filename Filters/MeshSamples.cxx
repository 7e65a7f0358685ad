// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSamples.h"

#include "GeometryImage.h"
#include "ImageChecks.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <cmath>

namespace bravais
{

namespace
{

/// Whether all cells are of points that there are.
bool CheckCells(vtkCellArray* cells, vtkIdType count, std::string& why)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      if (id < 0 || id >= count)
      {
        why = "A polygon or strip of the input has point " + std::to_string(id) +
          "; one of its points, 0 to " + std::to_string(count - 1) + ", was expected.";
        return false;
      }
    }
  }
  return true;
}

/// Polygons and strips as triangles of the mesh's points.
std::vector<Triangle> ReadTriangles(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> surface; // without what is no surface
  surface->SetPoints(mesh->GetPoints());
  surface->SetPolys(mesh->GetPolys());
  surface->SetStrips(mesh->GetStrips());
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(surface);
  triangulate->Update();
  vtkCellArray* cells = triangulate->GetOutput()->GetPolys();
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    triangles.push_back({ { static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)),
      static_cast<int>(ids->GetId(2)) } });
  }
  return triangles;
}

/// Scales sampled normals to length 1.
void NormalizeVectors(vtkDataArray* normals)
{
  for (vtkIdType n = 0; normals && n < normals->GetNumberOfTuples(); ++n)
  {
    double normal[3];
    normals->GetTuple(n, normal);
    if (vtkMath::Normalize(normal) > 0.0)
    {
      normals->SetTuple(n, normal);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
bool MeshSamples::SetMesh(vtkPolyData* mesh, std::string& why)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (count < 1 || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() < 1)
  {
    why = "The input has " + std::to_string(count) + " points and " +
      std::to_string(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips()) +
      " polygons and strips; a surface was expected.";
    return false;
  }
  if (count > VTK_INT_MAX / 8)
  {
    why = "The input has " + std::to_string(count) + " points; at most " +
      std::to_string(VTK_INT_MAX / 8) + " were expected.";
    return false;
  }
  if (!CheckPointArrays(mesh, why) || !CheckCells(mesh->GetPolys(), count, why) ||
    !CheckCells(mesh->GetStrips(), count, why))
  {
    return false;
  }
  std::vector<glm::dvec3> points(static_cast<std::size_t>(count));
  for (vtkIdType n = 0; n < count; ++n)
  {
    glm::dvec3& p = points[static_cast<std::size_t>(n)];
    mesh->GetPoint(n, &p.x);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    {
      why = "Point " + std::to_string(n) + " is at (" + std::to_string(p.x) + ", " +
        std::to_string(p.y) + ", " + std::to_string(p.z) + "); finite coordinates were expected.";
      return false;
    }
  }
  if (!this->Layout.SetMesh(std::move(points), ReadTriangles(mesh), why))
  {
    return false;
  }
  this->Attributes->DeepCopy(mesh->GetPointData());
  this->Attributes->RemoveArray(GeometryImagePoints);
  this->Attributes->RemoveArray(GeometryImageDefined);
  this->Points = mesh->GetPoints()->GetData();
  if (!this->Layout.GetSplitEdges().empty())
  {
    this->AddSplitPoints();
  }
  return true;
}

//------------------------------------------------------------------------------
void MeshSamples::AddSplitPoints()
{
  const vtkIdType count = this->Points->GetNumberOfTuples();
  auto points = vtkSmartPointer<vtkDataArray>::Take(this->Points->NewInstance());
  points->DeepCopy(this->Points);
  vtkNew<vtkPointData> attributes;
  attributes->InterpolateAllocate(this->Attributes);
  for (vtkIdType n = 0; n < count; ++n)
  {
    attributes->CopyData(this->Attributes, n, n);
  }
  vtkIdType next = count;
  for (const Ends& edge : this->Layout.GetSplitEdges())
  {
    points->InterpolateTuple(next, edge[0], points, edge[1], points, 0.5);
    attributes->InterpolateEdge(this->Attributes, next, edge[0], edge[1], 0.5);
    ++next;
  }
  this->Points = points;
  this->Attributes->ShallowCopy(attributes);
}

//------------------------------------------------------------------------------
bool MeshSamples::Sample(
  const int dimensions[2], int rounds, SurfaceParametrization::Progress progress, std::string& why)
{
  const double longer = std::max(dimensions[0], dimensions[1]) - 1.0;
  const glm::dvec2 size((dimensions[0] - 1.0) / longer, (dimensions[1] - 1.0) / longer);
  if (!this->Layout.LayOut(size, rounds, std::move(progress), why))
  {
    return false;
  }
  this->Width = dimensions[0];
  this->Samples = SampleSurface(
    this->Layout.GetMesh(), this->Layout.GetParameters(), dimensions[0], dimensions[1]);
  return true;
}

//------------------------------------------------------------------------------
void MeshSamples::Fill(vtkImageData* image) const
{
  int extent[6];
  image->GetExtent(extent);
  vtkPointData* data = image->GetPointData();
  data->InterpolateAllocate(this->Attributes, image->GetNumberOfPoints());
  const int type = this->Points->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  auto points = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  points->SetName(GeometryImagePoints);
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(image->GetNumberOfPoints());
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  vtkIdType gixel = 0;
  for (int y = extent[2]; y <= extent[3]; ++y)
  {
    for (int x = extent[0]; x <= extent[1]; ++x, ++gixel)
    {
      SurfaceSample sample =
        this->Samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
          static_cast<std::size_t>(x)];
      const Triangle& triangle =
        this->Layout.GetMesh().GetTriangles()[static_cast<std::size_t>(sample.Triangle)];
      double place[3] = { 0.0, 0.0, 0.0 };
      for (std::size_t k = 0; k < 3; ++k)
      {
        double p[3];
        this->Points->GetTuple(triangle[k], p);
        corners->SetId(static_cast<vtkIdType>(k), triangle[k]);
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += sample.Weights[k] * p[axis];
        }
      }
      points->SetTuple(gixel, place);
      data->InterpolatePoint(this->Attributes.GetPointer(), gixel, corners, sample.Weights.data());
    }
  }
  NormalizeVectors(data->GetNormals());
  data->AddArray(points);
  TagGeometryImage(image);
}

} // namespace bravais
