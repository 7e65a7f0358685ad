// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeTest_h
#define VolumeTest_h

#include "CellGrid.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// \file
/// Whether cells meet a volume, which is where a function is negative. Where the function is
/// evaluated as its owner does, the tests are exact in rounded numbers too: sums and products round
/// monotonely, so a bound of the function at a cell's corner, in the same operations, bounds its
/// rounded values at all gixels within. Others allow for rounding, on the side of Partly.

namespace bravais
{

enum class Overlap
{
  Outside, ///< the function is nowhere negative in the cell
  Partly,  ///< it may be
  Inside   ///< it is negative everywhere
};

/// A volume. Pending starts as AllPending at the root; what a test has found about a cell that
/// holds for all cells in it, it notes there.
class VolumeTest
{
public:
  static constexpr std::uint64_t AllPending = ~std::uint64_t{ 0 };

  virtual ~VolumeTest() = default;
  virtual Overlap Classify(const Box& cell, std::uint64_t& pending) const = 0;

  /// Whether a point is in the volume; of one in a cell that was classified, with what that left
  /// pending, only this is asked.
  virtual bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const = 0;
};

/// The largest of normal . (x - origin) + offset is negative: a polyhedron. Cells outside of one
/// plane are found to be outside; of others that miss the volume near an edge or corner it is said
/// that they are partly in it.
class PlanesTest : public VolumeTest
{
public:
  struct Plane
  {
    glm::dvec3 Normal;
    glm::dvec3 Origin;
    double Offset = 0.0;
    bool Exact = true; // not derived from others, by rounding
  };

  explicit PlanesTest(std::vector<Plane> planes);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const override;

private:
  static constexpr std::size_t Noted = 64; // planes beyond these are tested again in each cell

  /// Whether the plane of a number has still to be tested, and the bit of Pending that says so.
  static bool IsPending(std::size_t plane, std::uint64_t pending)
  {
    return plane >= Noted || (pending >> plane & 1);
  }

  std::vector<Plane> Planes;
};

/// (x - center)^2 - radius^2 is negative.
class SphereTest : public VolumeTest
{
public:
  SphereTest(const glm::dvec3& center, double radius);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const override;

private:
  glm::dvec3 Center;
  double Square;
};

/// (matrix x + shift)^2 - radius^2 is negative: a sphere seen through any linear transform.
class EllipsoidTest : public VolumeTest
{
public:
  EllipsoidTest(const glm::dmat3& matrix, const glm::dvec3& shift, double radius);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const override;

private:
  double GetValue(const glm::dvec3& point) const;
  double GetMinimum(const Box& cell) const;

  glm::dmat3 Matrix;
  glm::dvec3 Shift;
  double Square;
};

/// Each coordinate is above the low and below the high corner's, or equal to both where they are.
class BoxTest : public VolumeTest
{
public:
  explicit BoxTest(const Box& box);
  Overlap Classify(const Box& cell, std::uint64_t& pending) const override;
  bool Contains(const glm::dvec3& point, std::uint64_t pending = AllPending) const override;

private:
  Box Bounds;
};

} // namespace bravais

#endif
