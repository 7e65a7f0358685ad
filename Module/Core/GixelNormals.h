// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelNormals_h
#define GixelNormals_h

#include "GixelTriangles.h"

#include <glm/vec3.hpp>

#include <optional>

namespace bravais
{

/// How a geometry image goes on beyond its border, as its own points tell: an edge is folded if its
/// gixels are the same from both its ends (a closed octahedral layout: gixel (-1, j) is then
/// (1, height - 1 - j)), and two opposite edges are joined if they are the same (a torus: gixel
/// (-1, j) is (width - 2, j)).
template <class T>
class GixelSeams
{
public:
  explicit GixelSeams(const GixelGrid<T>& grid);

  /// Number of the gixel of a column and row at most one beyond the border; nothing where the
  /// surface ends there, or that gixel is not used.
  std::optional<std::int64_t> Find(int column, int row) const;

private:
  GixelGrid<T> Grid;
  bool FoldedColumns[2]; // the first column and the last
  bool FoldedRows[2];
  bool JoinedColumns; // the first is the last
  bool JoinedRows;
};

/// The unit normal at a used gixel: the cross product of the central differences along columns and
/// rows, one-sided where there is no neighbour. Where that vanishes, the sum of the triangles'
/// round the gixel, and (0, 0, 1) where those have no area either.
template <class T>
glm::dvec3 GetGixelNormal(
  const GixelGrid<T>& grid, const GixelSeams<T>& seams, int column, int row);

} // namespace bravais

#endif
