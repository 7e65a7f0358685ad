// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellGrid_h
#define CellGrid_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace bravais
{

/// A box with its lower and its upper corner.
struct Box
{
  glm::dvec3 Low;
  glm::dvec3 High;
};

/**
 * A cube cut into 2^depth cells along each axis, half-open: cell k along an axis holds the numbers
 * x with floor((x - corner) / edge * 2^depth) = k. The cells of all smaller depths are unions of
 * these, so that a gixel's cell at any depth is a prefix of its Morton code.
 *
 * As that formula rounds, the true boundary between two cells is the least number that it sends to
 * the upper one. Those numbers are kept, so that a box of cells holds its gixels to the last bit.
 */
class CellGrid
{
public:
  static constexpr int MaximumDepth = 10;                      // codes fit 30 bits
  static constexpr std::uint32_t NoCell = ~std::uint32_t{ 0 }; // the code of what is in no cell

  /// A finite corner, a finite and positive edge that the corner's rounding does not swallow, and a
  /// depth from 0 to MaximumDepth.
  static std::optional<CellGrid> Create(const glm::dvec3& corner, double edge, int depth);

  /// The smallest cube round a box, concentric with it, with its edge times 1 + 1e-6, so that the
  /// box is inside. Round a point, or a box too thin to tell its faces apart, a small one.
  static std::optional<CellGrid> CreateRound(const Box& box, int depth);

  int GetDepth() const { return this->Depth; }
  const glm::dvec3& GetCorner() const { return this->Corner; }
  double GetEdge() const { return this->Edge; }

  /// Morton code of a point's cell, x in the highest of each three bits, or NoCell.
  std::uint32_t GetCode(const glm::dvec3& point) const;

  /// The box, closed below and open above, of the cell of these coordinates at a depth.
  Box GetBox(const glm::ivec3& cell, int depth) const
  {
    const int shift = this->Depth - depth;
    const std::size_t faces = (std::size_t{ 1 } << this->Depth) + 1;
    const double* x = this->Boundaries.data();
    const double* y = x + faces;
    const double* z = y + faces;
    const glm::ivec3 low(cell.x << shift, cell.y << shift, cell.z << shift);
    const int width = 1 << shift;
    const Box box{ { x[low.x], y[low.y], z[low.z] },
      { x[low.x + width], y[low.y + width], z[low.z + width] } };
    return box;
  }

private:
  CellGrid(const glm::dvec3& corner, double edge, int depth);

  double GetCell(int axis, double x) const;
  double FindBoundary(int axis, int cell) const;

  glm::dvec3 Corner;
  double Edge;
  int Depth;
  std::vector<double> Boundaries; // 2^depth + 1 of each axis
};

/// Morton code of cell coordinates up to 10 bits, and back.
std::uint32_t ToMorton(const glm::ivec3& cell);
glm::ivec3 FromMorton(std::uint32_t code);

} // namespace bravais

#endif
