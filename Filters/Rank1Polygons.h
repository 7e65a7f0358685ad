// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Polygons_h
#define Rank1Polygons_h

/// \file
/// Polygons of a rank-1 image, found by many threads and then put together in the texels' order.

#include "Rank1Cells.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkCellArray;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Polygons of some texels.
struct Rank1Polygons
{
  /// A vertex that is no texel of its own: a cut end of a triangle, or a corner of a cell.
  struct Vertex
  {
    glm::dvec2 Position;
    glm::dvec3 Barycentric; ///< in the triangle of these texels
    std::array<std::int64_t, 3> Texels;
  };
  std::vector<Vertex> Vertices;
  std::vector<vtkIdType> Sizes;   ///< of the polygons
  std::vector<vtkIdType> Corners; ///< texels where not negative, else -1 - vertex
  std::vector<vtkIdType> Texels;  ///< of the polygons, where they are cells
};

/// Polygons of texels first .. last - 1 in runs, one after the other; empty where aborted. Progress
/// runs from 0 to end.
std::vector<Rank1Polygons> FindRank1VoronoiCells(
  vtkAlgorithm* self, const Rank1Cells& cells, vtkIdType first, vtkIdType last, double end);
std::vector<Rank1Polygons> FindRank1Triangles(
  vtkAlgorithm* self, const Rank1Cells& cells, vtkIdType first, vtkIdType last, double end);

/// Number of the first vertex of each run, and of all at the end.
std::vector<vtkIdType> CountRank1Vertices(const std::vector<Rank1Polygons>& runs);

/// The polygons of all runs; `texel` tells the point of a texel, and vertices are points from
/// `firstVertex` on.
void FillRank1Polygons(const std::vector<Rank1Polygons>& runs,
  const std::function<vtkIdType(vtkIdType)>& texel, vtkIdType firstVertex, vtkCellArray* polygons);

} // namespace bravais

#endif
