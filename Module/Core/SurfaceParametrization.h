// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceParametrization_h
#define SurfaceParametrization_h

#include "SpringEmbedding.h"

#include <functional>
#include <optional>
#include <vector>

namespace bravais
{

/// Spreads a disk over a rectangle, or a closed surface of genus 0 over a folded one, so that no
/// triangle is turned over and the stretch is low.
class SurfaceParametrization
{
public:
  /// Told from time to time which part of the work is done; false stops it.
  using Progress = std::function<bool(double)>;

  SurfaceParametrization(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points,
    const glm::dvec2& size, Progress progress);

  /// So many rounds of global descent at most; fewer where they remove little. Nothing if stopped,
  /// or if no embedding was found in double precision.
  std::optional<SurfaceParameters> Execute(int rounds);
  /// Of a disk whose rim is where `start` has fixed it.
  std::optional<SurfaceParameters> Execute(int rounds, SurfaceParameters start);

  bool IsStopped() const { return this->Stopped; }

private:
  bool Report(double part);
  std::vector<SurfaceParameters> FindLayouts() const;
  bool Embed(
    SpringEmbedding& springs, SurfaceParameters& parameters, std::vector<double>& weights) const;
  double Loosen(SpringEmbedding& springs, int solves, SurfaceParameters& parameters,
    std::vector<double>& weights) const;
  bool Descend(int rounds, SurfaceParameters& parameters);

  const TriangleTopology& Mesh;
  const std::vector<glm::dvec3>& Points;
  glm::dvec2 Size;
  std::vector<TriangleShape> Shapes;
  Progress Tell;
  bool Stopped = false;
};

} // namespace bravais

#endif
