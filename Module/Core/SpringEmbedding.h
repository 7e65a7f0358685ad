// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SpringEmbedding_h
#define SpringEmbedding_h

#include "SurfaceParameters.h"

#include <memory>
#include <vector>

namespace bravais
{

/// Places every free vertex at the weighted mean of its neighbours, by one sparse solve.
class SpringEmbedding
{
public:
  SpringEmbedding(const TriangleTopology& mesh, const SurfaceParameters& parameters);
  ~SpringEmbedding();

  /// `weights` are of half-edges, positive, the same for twins. False if the solve fails.
  bool Solve(const std::vector<double>& weights, SurfaceParameters& parameters);

private:
  struct Internals;
  std::unique_ptr<Internals> Members;
};

/// Weights of a conformal map, but positive whatever the triangles.
std::vector<double> GetConformalWeights(
  const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes);

/// Divides weights by the stretch round their ends: where the surface is stretched, springs
/// get weaker and make room. S. Yoshizawa, A. Belyaev, H.-P. Seidel, "A fast and simple
/// stretch-minimizing mesh parameterization", SMI 2004.
void WeakenStretched(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  const SurfaceParameters& parameters, std::vector<double>& weights);

} // namespace bravais

#endif
