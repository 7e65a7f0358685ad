// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CullVolume.h"

#include "vtkAbstractTransform.h"
#include "vtkBox.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkSphere.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace bravais
{

namespace
{

using Plane = PlanesTest::Plane;

/// World to the function's own coordinates: matrix x + shift.
struct Affine
{
  glm::dmat3 Matrix = glm::dmat3(1.0);
  glm::dvec3 Shift = glm::dvec3(0.0);
};

glm::dvec3 ToVector(const double x[3])
{
  return { x[0], x[1], x[2] };
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string Join(const glm::dvec3& v)
{
  std::ostringstream text;
  text << "(" << v.x << ", " << v.y << ", " << v.z << ")";
  return text.str();
}

/// None if the transform is not affine.
std::optional<Affine> GetAffine(vtkAbstractTransform* transform)
{
  auto* homogeneous = vtkHomogeneousTransform::SafeDownCast(transform);
  if (!homogeneous)
  {
    return std::nullopt;
  }
  homogeneous->Update();
  vtkMatrix4x4* matrix = homogeneous->GetMatrix();
  Affine affine;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      affine.Matrix[column][row] = matrix->GetElement(row, column);
    }
    affine.Shift[row] = matrix->GetElement(row, 3);
  }
  const bool last = matrix->GetElement(3, 0) == 0.0 && matrix->GetElement(3, 1) == 0.0 &&
    matrix->GetElement(3, 2) == 0.0 && matrix->GetElement(3, 3) == 1.0;
  return last && IsFinite(affine.Matrix[0]) && IsFinite(affine.Matrix[1]) &&
      IsFinite(affine.Matrix[2]) && IsFinite(affine.Shift)
    ? std::optional(affine)
    : std::nullopt;
}

/// A plane of the function's coordinates in those of the world.
Plane ToWorld(const Affine& affine, const Plane& plane)
{
  Plane world{ plane.Normal * affine.Matrix, glm::dvec3(0.0), 0.0, false };
  const glm::dvec3 from = affine.Shift - plane.Origin;
  world.Offset = plane.Normal.x * from.x + plane.Normal.y * from.y + plane.Normal.z * from.z;
  return world;
}

bool CheckPlane(const glm::dvec3& normal, const glm::dvec3& origin, std::string& why)
{
  if (IsFinite(normal) && IsFinite(origin))
  {
    return true;
  }
  why = "CullFunction has a plane through " + Join(origin) + " with the normal " + Join(normal) +
    "; finite numbers were expected.";
  return false;
}

bool GetPlanes(vtkPlanes* planes, std::vector<Plane>& found, std::string& why)
{
  const vtkIdType points = planes->GetPoints() ? planes->GetPoints()->GetNumberOfPoints() : 0;
  const vtkIdType normals = planes->GetNormals() ? planes->GetNormals()->GetNumberOfTuples() : 0;
  if (points < 1 || points != normals)
  {
    why = "CullFunction is a vtkPlanes of " + std::to_string(points) + " points and " +
      std::to_string(normals) + " normals; at least one and as many of both were expected.";
    return false;
  }
  for (vtkIdType n = 0; n < points; ++n)
  {
    double normal[3];
    double point[3];
    planes->GetNormals()->GetTuple(n, normal);
    planes->GetPoints()->GetPoint(n, point);
    if (!CheckPlane(ToVector(normal), ToVector(point), why))
    {
      return false;
    }
    found.push_back({ ToVector(normal), ToVector(point) });
  }
  return true;
}

bool GetBox(vtkBox* box, Box& bounds, std::string& why)
{
  double low[3];
  double high[3];
  box->GetXMin(low);
  box->GetXMax(high);
  bounds = { ToVector(low), ToVector(high) };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(low[axis] <= high[axis]) || !std::isfinite(high[axis] - low[axis]))
    {
      why = "CullFunction is a vtkBox from " + Join(bounds.Low) + " to " + Join(bounds.High) +
        "; finite numbers in ascending order were expected.";
      return false;
    }
  }
  return true;
}

std::unique_ptr<VolumeTest> MakePlanesTest(
  vtkImplicitFunction* function, std::vector<Plane> planes, const Affine& affine)
{
  if (function->GetTransform())
  {
    for (Plane& plane : planes)
    {
      plane = ToWorld(affine, plane);
    }
  }
  return std::make_unique<PlanesTest>(std::move(planes));
}

bool MakePlanes(
  vtkImplicitFunction* function, const Affine& affine, CullVolume& volume, std::string& why)
{
  std::vector<Plane> planes;
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    planes.push_back({ ToVector(plane->GetNormal()), ToVector(plane->GetOrigin()) });
    if (!CheckPlane(planes[0].Normal, planes[0].Origin, why))
    {
      return false;
    }
  }
  else if (!GetPlanes(vtkPlanes::SafeDownCast(function), planes, why))
  {
    return false;
  }
  volume.Test = MakePlanesTest(function, std::move(planes), affine);
  return true;
}

bool MakeBox(vtkBox* function, const Affine& affine, CullVolume& volume, std::string& why)
{
  Box box;
  if (!GetBox(function, box, why))
  {
    return false;
  }
  if (!function->GetTransform())
  {
    volume.Test = std::make_unique<BoxTest>(box);
    return true;
  }
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.Low[axis] == box.High[axis])
    {
      return true; // a turned rectangle has no inside that cells could be tested for
    }
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    planes.push_back({ normal, box.High });
    planes.push_back({ -normal, box.Low });
  }
  volume.Test = MakePlanesTest(function, std::move(planes), affine);
  return true;
}

bool MakeSphere(vtkSphere* function, const Affine& affine, CullVolume& volume, std::string& why)
{
  const glm::dvec3 center = ToVector(function->GetCenter());
  const double radius = function->GetRadius();
  if (!IsFinite(center) || !std::isfinite(radius))
  {
    why = "CullFunction is a vtkSphere about " + Join(center) + " of radius " +
      std::to_string(radius) + "; finite numbers were expected.";
    return false;
  }
  if (function->GetTransform())
  {
    volume.Test = std::make_unique<EllipsoidTest>(affine.Matrix, affine.Shift - center, radius);
  }
  else
  {
    volume.Test = std::make_unique<SphereTest>(center, radius);
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool MakeCullVolume(vtkImplicitFunction* function, CullVolume& volume, std::string& why)
{
  volume.Test.reset();
  volume.Function = function;
  vtkAbstractTransform* transform = function->GetTransform();
  const std::optional<Affine> affine = transform ? GetAffine(transform) : Affine{};
  // By name, as a class derived from one of these may be another function.
  const std::string name = function->GetClassName();
  bool good = true;
  if (name == "vtkPlane" || name == "vtkPlanes")
  {
    good = MakePlanes(function, affine.value_or(Affine{}), volume, why);
  }
  else if (name == "vtkBox")
  {
    good = MakeBox(vtkBox::SafeDownCast(function), affine.value_or(Affine{}), volume, why);
  }
  else if (name == "vtkSphere")
  {
    good = MakeSphere(vtkSphere::SafeDownCast(function), affine.value_or(Affine{}), volume, why);
  }
  if (!affine)
  {
    volume.Test.reset();
  }
  if (volume.Test && !transform)
  {
    volume.Function = nullptr; // the test gives what the function gives
  }
  return good;
}

//------------------------------------------------------------------------------
bool MakeCullVolume(vtkCamera* camera, double aspectRatio, CullVolume& volume, std::string& why)
{
  if (!(aspectRatio > 0.0) || !std::isfinite(aspectRatio))
  {
    std::ostringstream text;
    text << "AspectRatio is " << aspectRatio << "; a finite number above 0 was expected.";
    why = text.str();
    return false;
  }
  double equations[24];
  camera->GetFrustumPlanes(aspectRatio, equations);
  vtkNew<vtkPlanes> planes;
  planes->SetFrustumPlanes(equations);
  if (!MakeCullVolume(planes, volume, why))
  {
    why = "The camera's frustum is not finite. " + why;
    return false;
  }
  return true;
}

} // namespace bravais
