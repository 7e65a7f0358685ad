// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshLayout.h"

#include "TriangleCleaning.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

/// Moves and scales points so that their box is about the origin and has a diagonal of 1. False if
/// they have no extent, or one that double has no number for.
bool Normalize(std::vector<glm::dvec3>& points, const std::vector<Triangle>& triangles)
{
  glm::dvec3 low = points[Index(triangles[0][0])];
  glm::dvec3 high = low;
  for (const Triangle& triangle : triangles)
  {
    for (const int corner : triangle)
    {
      low = glm::min(low, points[Index(corner)]);
      high = glm::max(high, points[Index(corner)]);
    }
  }
  const glm::dvec3 extent = high - low;
  const double most = std::max({ extent.x, extent.y, extent.z });
  if (!(most > 0.0) || !std::isfinite(most))
  {
    return false;
  }
  for (glm::dvec3& point : points)
  {
    point = (point - low) / most - 0.5 * (extent / most);
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool MeshLayout::SetMesh(
  std::vector<glm::dvec3> points, std::vector<Triangle> triangles, std::string& why)
{
  MergeCoincidentPoints(points, triangles);
  RemoveRepeatedTriangles(triangles);
  this->Points = std::move(points);
  const int vertices = static_cast<int>(this->Points.size());
  if (!triangles.empty() && !Normalize(this->Points, triangles))
  {
    why = "The points' box is too large for double precision.";
    return false;
  }
  if (!this->Mesh.Set(vertices, std::move(triangles), why))
  {
    return false;
  }
  const int genus = this->Mesh.GetGenus();
  const int boundaries = this->Mesh.GetNumberOfBoundaries();
  if (genus != 0 || boundaries > 1)
  {
    why = "The mesh has genus " + std::to_string(genus) + " and " + std::to_string(boundaries) +
      (boundaries == 1 ? " boundary" : " boundaries") +
      "; genus 0 with no boundary (a closed surface) or 1 boundary (a disk) was expected.";
    return false;
  }
  if (this->IsClosed())
  {
    return true;
  }
  const std::vector<int>& rim = this->Mesh.GetBoundary(0);
  if (rim.size() < 4 && !this->Refine({ { { rim[0], rim[1] } } }, why))
  {
    return false;
  }
  this->Corners = FindRimCorners(this->Mesh, this->Points);
  return this->Refine(FindChords(this->Mesh, this->Corners), why);
}

//------------------------------------------------------------------------------
bool MeshLayout::Refine(const std::vector<Ends>& edges, std::string& why)
{
  if (edges.empty())
  {
    return true;
  }
  std::vector<Triangle> triangles = SplitEdges(this->Mesh, edges);
  for (const Ends& edge : edges)
  {
    this->Points.push_back(0.5 * (this->Points[Index(edge[0])] + this->Points[Index(edge[1])]));
    this->Split.push_back(edge);
  }
  return this->Mesh.Set(static_cast<int>(this->Points.size()), std::move(triangles), why);
}

//------------------------------------------------------------------------------
bool MeshLayout::LayOut(
  const glm::dvec2& size, int rounds, SurfaceParametrization::Progress progress, std::string& why)
{
  SurfaceParametrization work(this->Mesh, this->Points, size, std::move(progress));
  std::optional<SurfaceParameters> parameters = this->IsClosed()
    ? work.Execute(rounds)
    : work.Execute(rounds, LayRim(this->Mesh, this->Points, this->Corners, size));
  if (!parameters)
  {
    why = work.IsStopped()
      ? ""
      : "The mesh could not be laid out without turning triangles over: parts of it are too long "
        "and thin for double precision.";
    return false;
  }
  this->Parameters = std::move(*parameters);
  return true;
}

//------------------------------------------------------------------------------
double MeshLayout::GetStretch() const
{
  return bravais::GetStretch(this->Mesh, GetShapes(this->Mesh, this->Points), this->Parameters);
}

} // namespace bravais
