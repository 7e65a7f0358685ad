// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Cells_h
#define Rank1Cells_h

#include "Rank1Interpolation.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace bravais
{

/**
 * Voronoi cells and Delaunay triangles of a rank-1 picture, cut at its border.
 *
 * The picture is periodic. What of a cell is beyond the border comes in again on the other side, as
 * a part of its own, so that the parts of all cells cover the picture once; likewise the triangles.
 * Positions are in units of the picture, 0 to 1.
 */
class Rank1Cells
{
public:
  /// The lattice's size is that of one tile.
  Rank1Cells(const Rank1Lattice& lattice, int tilesX, int tilesY);

  /// All texels of all tiles.
  std::int64_t GetNumberOfTexels() const;

  /// Place of a texel.
  glm::dvec2 GetPoint(std::int64_t texel) const;

  /// A corner of a part, and its barycentric coordinates in the triangle that the part is of.
  struct Corner
  {
    glm::dvec2 Position;
    glm::dvec3 Barycentric;
  };
  /// Counter-clockwise.
  using Part = std::vector<Corner>;

  /// The parts of a texel's Voronoi cell, most often one; barycentric coordinates mean nothing.
  void FindCellParts(std::int64_t texel, std::vector<Part>& parts) const;

  /// Triangle 0 or 1 of the cell of the basis whose corner is a texel: its vertices' texels,
  /// counter- clockwise.
  struct Triangle
  {
    std::array<std::int64_t, 3> Texels;
    std::array<glm::dvec2, 3> Positions; ///< from the first texel's place; may be beyond the border
    bool IsInside;                       ///< whether all positions are the texels' own
  };
  Triangle GetTriangle(std::int64_t texel, int which) const;

  /// The parts of a triangle.
  void FindTriangleParts(const Triangle& triangle, std::vector<Part>& parts) const;

private:
  void FindParts(const Part& polygon, std::vector<Part>& parts) const;

  Rank1Lattice Lattice;
  Rank1Texture<double> Texture;
  glm::dvec2 Tiles;
  std::array<glm::dvec2, 6> Cell; ///< in units of the picture
};

} // namespace bravais

#endif
