// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCBricks_h
#define BCCBricks_h

#include "BCCKernel.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace bravais
{

/// Spline coefficients of both cosets of a box, each with a halo, as a texture holds them: lattice
/// point (X, Y, Z) is texel (X >> 1, Y >> 1, Z >> 1) + Halo, in the upper half of the slices where
/// the coordinates are odd.
struct BCCTexels
{
  static constexpr int Halo = 2;

  const float* Values; ///< x fastest, components interleaved
  glm::ivec3 Size;     ///< of both cosets together
  int Components;

  /// The texels from x = 0 on of a row of points.
  const float* GetRow(int Y, int Z) const
  {
    const int slice = (Z >> 1) + Halo + (Z & 1) * (this->Size.z / 2);
    const int row = (Y >> 1) + Halo;
    return this->Values +
      (static_cast<std::size_t>(slice) * static_cast<std::size_t>(this->Size.y) +
        static_cast<std::size_t>(row)) *
      static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Components);
  }
};

/**
 * Bounds of a spline in bricks of its box.
 *
 * Brick (a, b, c) is the part of the box that lies in Edge (a, b, c) .. Edge (a + 1, b + 1, c + 1),
 * in lattice coordinates. The kernels are not negative and their shifts sum to 1, so in a brick the
 * spline is a mean of the coefficients whose kernels reach into it, between the least and the
 * largest. Those far from the brick have little weight: the bounds are the extrema of the near ones
 * and, by that weight, as much nearer to the extrema of all. Where one of these is not finite, the
 * bounds are -infinity and infinity.
 */
class BCCBricks
{
public:
  static constexpr int Edge = 5;

  /// Bricks of the box 0 <= X <= last, its coordinates along z from `firstLayer` (0 or 1) on.
  BCCBricks(const glm::ivec3& last, int firstLayer, int components);

  /// Computes the bricks of one layer; different layers may be computed at the same time.
  void ComputeLayer(BCCKernel kernel, const BCCTexels& texels, int layer);

  const glm::ivec3& GetSize() const { return this->Size; }
  int GetComponents() const { return this->Components; }

  /// Bounds of all bricks, x fastest, components interleaved.
  const std::vector<float>& GetLow() const { return this->Low; }
  const std::vector<float>& GetHigh() const { return this->High; }

  /// How far a kernel reaches along each axis, in lattice coordinates: at that distance it is 0.
  static int GetReach(BCCKernel kernel);

  /// Coefficients less than this away from a brick along every axis are near it; and the largest
  /// weight that all others together have there.
  static int GetNearReach(BCCKernel kernel);
  static float GetFarWeight(BCCKernel kernel);

private:
  struct Row;
  struct Rows;
  void ReduceRow(const Rows& rows, BCCKernel kernel, std::size_t brick);

  glm::ivec3 Last;
  int FirstLayer;
  int Components;
  glm::ivec3 Size;
  std::vector<float> Low;
  std::vector<float> High;
};

} // namespace bravais

#endif
