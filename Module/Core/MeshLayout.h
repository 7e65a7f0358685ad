// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshLayout_h
#define MeshLayout_h

#include "DiskRim.h"
#include "SurfaceParametrization.h"

#include <string>

namespace bravais
{

/// A mesh made ready for a rectangle: cleaned, checked, scaled, and, if a disk, refined where
/// that has to be; then laid into it.
class MeshLayout
{
public:
  /// False if the mesh is no disk and no closed surface of genus 0; `why` tells what was found.
  bool SetMesh(std::vector<glm::dvec3> points, std::vector<Triangle> triangles, std::string& why);

  /// See SurfaceParametrization. False if that was stopped or fails, with an empty or a filled
  /// `why`.
  bool LayOut(const glm::dvec2& size, int rounds, SurfaceParametrization::Progress progress,
    std::string& why);

  bool IsClosed() const { return this->Mesh.GetNumberOfBoundaries() == 0; }
  const TriangleTopology& GetMesh() const { return this->Mesh; }
  const SurfaceParameters& GetParameters() const { return this->Parameters; }
  /// Edges whose middles are vertices that the mesh did not have, numbered on from its own.
  const std::vector<Ends>& GetSplitEdges() const { return this->Split; }
  double GetStretch() const;

private:
  bool Refine(const std::vector<Ends>& edges, std::string& why);

  TriangleTopology Mesh;
  std::vector<glm::dvec3> Points;
  std::vector<Ends> Split;
  std::array<int, 4> Corners{};
  SurfaceParameters Parameters;
};

} // namespace bravais

#endif
