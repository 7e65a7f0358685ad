// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StretchDescent_h
#define StretchDescent_h

#include "SurfaceParameters.h"

#include <memory>
#include <vector>

namespace bravais
{

/// Lessens the distortion, see DistortionFactor, by moving all free vertices at once.
class StretchDescent
{
public:
  StretchDescent(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
    const SurfaceParameters& parameters);
  ~StretchDescent();

  /// So many steps of the limited-memory BFGS method, whose first guess of the second derivatives
  /// is a Laplacian of the plane weighted by each triangle's distortion. Steps are shortened until
  /// that falls, so no triangle is ever turned over. Returns which part of it was removed.
  double Descend(int steps, SurfaceParameters& parameters);

private:
  struct Internals;
  std::unique_ptr<Internals> Members;
};

} // namespace bravais

#endif
