// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceParameters.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<TriangleShape> GetShapes(
  const TriangleTopology& mesh, const std::vector<glm::dvec3>& points)
{
  std::vector<TriangleShape> shapes;
  shapes.reserve(mesh.GetTriangles().size());
  double sum = 0.0;
  for (const Triangle& t : mesh.GetTriangles())
  {
    const glm::dvec3 a = points[Index(t[2])] - points[Index(t[1])];
    const glm::dvec3 b = points[Index(t[0])] - points[Index(t[2])];
    const glm::dvec3 c = points[Index(t[1])] - points[Index(t[0])];
    shapes.push_back({ { { glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) } },
      0.5 * glm::length(glm::cross(a, b)) });
    sum += shapes.back().Area;
  }
  // A triangle without area would be free to shrink to nothing in the plane.
  constexpr double part = 1e-4; // of the mean area
  const double least = sum > 0.0 ? part * sum / static_cast<double>(shapes.size()) : part;
  for (TriangleShape& shape : shapes)
  {
    shape.Area = std::max(shape.Area, least);
    for (double& square : shape.Squares)
    {
      square = std::max(square, least);
    }
  }
  return shapes;
}

//------------------------------------------------------------------------------
double GetStretch(const TriangleShape& shape, const std::array<glm::dvec2, 3>& u)
{
  const glm::dvec2 a = u[2] - u[1];
  const glm::dvec2 b = u[0] - u[2];
  const glm::dvec2 c = u[1] - u[0];
  const double area = Cross(a, b); // twice
  if (!(area > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double sum = shape.Squares[0] * glm::dot(b, c) + shape.Squares[1] * glm::dot(c, a) +
    shape.Squares[2] * glm::dot(a, b);
  return -0.5 * shape.Area * sum / (area * area);
}

//------------------------------------------------------------------------------
double GetDistortion(const TriangleShape& shape, const std::array<glm::dvec2, 3>& u)
{
  const double stretch = GetStretch(shape, u);
  if (!std::isfinite(stretch))
  {
    return stretch;
  }
  const double d = Cross(u[1] - u[0], u[2] - u[0]);
  return stretch * d * d * DistortionFactor(shape.Area, d).Value;
}

//------------------------------------------------------------------------------
std::array<glm::dvec2, 3> GetCorners(
  const TriangleTopology& mesh, const SurfaceParameters& parameters, int triangle)
{
  std::array<glm::dvec2, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    const int h = 3 * triangle + k;
    corners[Index(k)] = parameters.GetCorner(h)(parameters.Places[Index(mesh.GetOrigin(h))]);
  }
  return corners;
}

//------------------------------------------------------------------------------
int CountFlipped(const TriangleTopology& mesh, const SurfaceParameters& parameters)
{
  int flipped = 0;
  for (int t = 0; t < static_cast<int>(mesh.GetTriangles().size()); ++t)
  {
    const auto u = GetCorners(mesh, parameters, t);
    flipped += !(Cross(u[1] - u[0], u[2] - u[0]) > 0.0);
  }
  return flipped;
}

//------------------------------------------------------------------------------
double GetStretch(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  const SurfaceParameters& parameters)
{
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t t = 0; t < shapes.size(); ++t)
  {
    sum += GetStretch(shapes[t], GetCorners(mesh, parameters, static_cast<int>(t)));
    area += shapes[t].Area;
  }
  return std::sqrt(sum * parameters.Size.x * parameters.Size.y) / area;
}

} // namespace bravais
