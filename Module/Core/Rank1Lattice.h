// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Lattice_h
#define Rank1Lattice_h

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace bravais
{

/**
 * A rank-1 lattice on a rectangle whose opposite sides are joined.
 *
 * The n points are x_i = ({i g1 / n}, {i g2 / n}) of the unit torus (Dammertz, Dammertz, Keller and
 * Lensch, Textures on Rank-1 Lattices, eq. 1). Multiplied by n they are integers, points of the
 * n x n grid, which repeated by multiples of n are a lattice of determinant n. Distances are
 * measured after the unit square is stretched to `size`, width x height (weighted norm).
 *
 * The basis is Minkowski-reduced: |b1| <= |b2| <= |b2 - b1| <= |b2 + b1|, so b1, b2, b2 - b1 and
 * their opposites are the six neighbours of 0, and (0, b1, b2) is a Delaunay triangle. b1 points to
 * the right, or up. Vectors of the basis are integers; their indices are k and l, and the point
 * s b1 + t b2 has index (s k + t l) mod n (Theorem 2).
 */
class Rank1Lattice
{
public:
  using Vector = glm::vec<2, std::int64_t>; ///< a point of the n x n grid, or of its repetition

  static constexpr std::int64_t MaximumNumberOfPoints = 0x7fffffff;
  static constexpr double MaximumAspect = 1e6; ///< of width to height, and of height to width

  /// The lattice of n points; g1 and g2 count modulo n. None where n is not 1 to
  /// MaximumNumberOfPoints, where g1, g2 and n have a common divisor, so that there are fewer than
  /// n points, or where IsSize(size) is false.
  static std::optional<Rank1Lattice> Create(
    std::int64_t n, std::int64_t g1, std::int64_t g2, const glm::dvec2& size = { 1.0, 1.0 });

  /// Whether a size is positive, finite, and of an aspect within MaximumAspect.
  static bool IsSize(const glm::dvec2& size);

  std::int64_t GetNumberOfPoints() const { return this->NumberOfPoints; }
  const Vector& GetGenerator() const { return this->Generator; }
  const glm::dvec2& GetSize() const { return this->Size; }

  /// Vector 0 or 1 of the reduced basis, in units of the n x n grid, and its index.
  const Vector& GetBasis(int which) const { return this->Basis[which]; }
  std::int64_t GetBasisIndex(int which) const { return this->BasisIndices[which]; }

  /// n or -n.
  std::int64_t GetDeterminant() const
  {
    return this->Basis[0].x * this->Basis[1].y - this->Basis[0].y * this->Basis[1].x;
  }

  /// A vector of the grid, on the area: in units of `size`.
  glm::dvec2 ToArea(const glm::dvec2& grid) const
  {
    return grid * this->Size / static_cast<double>(this->NumberOfPoints);
  }

  /// Point i on the n x n grid and on the unit torus; i counts modulo n.
  Vector GetGridPoint(std::int64_t i) const;
  glm::dvec2 GetPoint(std::int64_t i) const;

  /// Coordinates (s, t) in the basis of a point (u, v) of the unit square or its repetition.
  glm::dvec2 ToBasis(const glm::dvec2& uv) const;

  /// Index of the point s b1 + t b2, for any s and t.
  std::int64_t GetIndex(std::int64_t s, std::int64_t t) const;

  /// Index of the point nearest to a finite (u, v) on the torus.
  std::int64_t FindNearest(const glm::dvec2& uv) const;

  /// Indices of the points at b1, b2, b2 - b1 from point i, then at their opposites.
  std::array<std::int64_t, 6> GetNeighbors(std::int64_t i) const;

  /// Length of b1, in units of `size`.
  double GetMinimumDistance() const;

  /// Share of the Voronoi cell that its in-circle covers, pi d^2 / (4 area): that of the dual
  /// lattice is the same, as in two dimensions the dual is the lattice turned and scaled. The
  /// square lattice has pi / 4, the hexagonal one pi / sqrt(12), the most that there is.
  double GetSamplingEfficiency() const;

  /// Corners of the Voronoi cell of 0, counter-clockwise, in units of the n x n grid. Two are equal
  /// where the cell is a rectangle.
  std::array<glm::dvec2, 6> GetVoronoiCell() const;

  /// Basis of the dual lattice, in units of 1 / `size`: products with the basis are 1 and 0.
  std::array<glm::dvec2, 2> GetDualBasis() const;

private:
  Rank1Lattice() = default;
  double GetProduct(const Vector& a, const Vector& b) const;
  void Reduce();

  std::int64_t NumberOfPoints = 1;
  Vector Generator = { 0, 0 };
  glm::dvec2 Size = { 1.0, 1.0 };
  glm::dvec2 Weights = { 1.0, 1.0 }; ///< Size without the common factor: 1, 1 for all squares
  std::array<Vector, 2> Basis = { Vector(1, 0), Vector(0, 1) };
  std::array<std::int64_t, 2> BasisIndices = { 0, 0 };
};

/// The remainder in 0 .. n - 1.
constexpr std::int64_t Modulo(std::int64_t value, std::int64_t n)
{
  const std::int64_t rest = value % n;
  return rest < 0 ? rest + n : rest;
}

/// g = gcd(a, b) >= 0 and integers with x a + y b = g.
struct Bezout
{
  std::int64_t Divisor;
  std::int64_t X;
  std::int64_t Y;
};
Bezout SolveBezout(std::int64_t a, std::int64_t b);

} // namespace bravais

#endif
