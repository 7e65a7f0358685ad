// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCLattice_h
#define BCCLattice_h

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace bravais
{

/**
 * A box of the body-centred cubic lattice, stored as layers.
 *
 * A point has an index (i, j, k), k its z-layer, and lattice coordinates
 *   X = 2 i + (k & 1),  Y = 2 j + (k & 1),  Z = k,
 * three integers of one parity: the even points are one Cartesian coset, the odd points the other.
 * Layers lie one after the other, x fastest, so no memory is wasted: linear = i + nx (j + ny k).
 *
 * Beyond the box the lattice is continued by whole-sample mirrors at X = 0 and 2 nx - 1, Y = 0 and
 * 2 ny - 1, Z = 0 and nk - 1. They move every coordinate by an even number, so a lattice point's
 * image is a lattice point of the same coset.
 */
class BCCLattice
{
public:
  /// The 8 nearest neighbours of the origin, at squared distance 3.
  static constexpr std::array<glm::ivec3, 8> Shell1 = { { { -1, -1, -1 }, { 1, -1, -1 },
    { -1, 1, -1 }, { 1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 }, { -1, 1, 1 }, { 1, 1, 1 } } };

  /// The 6 second neighbours of the origin, at squared distance 4, in its own coset.
  static constexpr std::array<glm::ivec3, 6> Shell2 = { { { -2, 0, 0 }, { 2, 0, 0 }, { 0, -2, 0 },
    { 0, 2, 0 }, { 0, 0, -2 }, { 0, 0, 2 } } };

  /// A box of nx * ny points in each of nk layers. Mirrors need nx, ny >= 1 and nk >= 2.
  explicit constexpr BCCLattice(const glm::ivec3& dimensions)
    : Dimensions(dimensions)
  {
  }

  constexpr const glm::ivec3& GetDimensions() const { return this->Dimensions; }

  constexpr std::int64_t GetNumberOfPoints() const
  {
    return std::int64_t{ this->Dimensions.x } * this->Dimensions.y * this->Dimensions.z;
  }

  /// The largest lattice coordinates of the box, where the far mirrors stand.
  constexpr glm::ivec3 GetLast() const
  {
    return { 2 * this->Dimensions.x - 1, 2 * this->Dimensions.y - 1, this->Dimensions.z - 1 };
  }

  /// Whether integer coordinates are a lattice point: all even or all odd.
  static constexpr bool IsPoint(const glm::ivec3& point)
  {
    return (((point.x ^ point.z) | (point.y ^ point.z)) & 1) == 0;
  }

  /// The coset of a lattice point, or of the points of layer k: 0 even, 1 odd.
  static constexpr int GetCoset(int k) { return k & 1; }

  /// Lattice coordinates of an index.
  static constexpr glm::ivec3 ToPoint(const glm::ivec3& index)
  {
    return { 2 * index.x + (index.z & 1), 2 * index.y + (index.z & 1), index.z };
  }

  /// Index of a lattice point; beyond the box as well (the halved numbers are even).
  static constexpr glm::ivec3 ToIndex(const glm::ivec3& point)
  {
    return { (point.x - (point.z & 1)) / 2, (point.y - (point.z & 1)) / 2, point.z };
  }

  /// Place of an index in memory.
  constexpr std::int64_t ToLinear(const glm::ivec3& index) const
  {
    return index.x +
      std::int64_t{ this->Dimensions.x } * (index.y + std::int64_t{ this->Dimensions.y } * index.z);
  }

  /// The coordinate in 0..last that whole-sample mirrors at 0 and last > 0 send x to.
  static constexpr int Mirror(int x, int last)
  {
    const int period = 2 * last;
    const int rest = x % period;
    const int positive = rest < 0 ? rest + period : rest;
    return positive > last ? period - positive : positive;
  }

  /// The point inside the box that the mirrors send a lattice point to.
  constexpr glm::ivec3 Mirror(const glm::ivec3& point) const
  {
    const glm::ivec3 last = this->GetLast();
    return { Mirror(point.x, last.x), Mirror(point.y, last.y), Mirror(point.z, last.z) };
  }

  /// Place in memory of any lattice point, mirrored into the box.
  constexpr std::int64_t ToLinearMirrored(const glm::ivec3& point) const
  {
    return this->ToLinear(ToIndex(this->Mirror(point)));
  }

  /// The lattice point nearest to a position in lattice coordinates; the even one of equals.
  static glm::ivec3 FindNearest(const glm::dvec3& position);

private:
  glm::ivec3 Dimensions;
};

} // namespace bravais

#endif
