// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelSampling_h
#define GixelSampling_h

#include "SurfaceParameters.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bravais
{

/// A point of a mesh: a triangle, and weights of its corners, not negative, that sum to 1.
struct SurfaceSample
{
  int Triangle = -1;
  std::array<double, 3> Weights{};
};

/// The points of a mesh at width x height places that span the rectangle from edge to edge, row by
/// row. Every triangle is drawn at all its places, and where several claim a gixel the one has it
/// that it is deepest in, the first among equals. Edges of a folded rectangle get the same samples
/// from both ends.
std::vector<SurfaceSample> SampleSurface(
  const TriangleTopology& mesh, const SurfaceParameters& parameters, int width, int height);

} // namespace bravais

#endif
