// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceParameters_h
#define SurfaceParameters_h

#include "FoldedSquare.h"
#include "TriangleTopology.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace bravais
{

/// Where the vertices of a mesh are in a rectangle, flat or folded.
struct SurfaceParameters
{
  glm::dvec2 Size;                // of the rectangle
  std::vector<HalfTurn> Corners;  // of half-edges, see FoldedCut; empty: nothing is folded
  std::vector<char> Fixed;        // of vertices
  std::vector<glm::dvec2> Places; // of vertices

  HalfTurn GetCorner(int h) const
  {
    return this->Corners.empty() ? HalfTurn() : this->Corners[static_cast<std::size_t>(h)];
  }
};

/// Squared lengths of a triangle's edges, each opposite to its corner, and the area; none less than
/// a ten-thousandth of the mean area.
struct TriangleShape
{
  std::array<double, 3> Squares;
  double Area;
};
std::vector<TriangleShape> GetShapes(
  const TriangleTopology& mesh, const std::vector<glm::dvec3>& points);

/// Area times the mean of the squared singular values of the map from a triangle of the plane to
/// one of the surface: P. V. Sander, J. Snyder, S. J. Gortler, H. Hoppe, "Texture mapping
/// progressive meshes", SIGGRAPH 2001, equation of L2. Infinite where the plane's triangle is not
/// positive.
double GetStretch(const TriangleShape& shape, const std::array<glm::dvec2, 3>& u);

/// What is lessened: the stretch, and a tenth of the stretch of the inverse map, so that no
/// direction is sampled much more densely than the other, which stretch alone does not mind. With M
/// / D^2 the sum of the squared singular values, D twice the area in the plane and A the surface's,
/// all of which sum to that of the plane, it is A M F(D) / 2, F(D) = 1 / D^2 + 0.1 / (4 A^2).
struct DistortionFactor
{
  DistortionFactor(double area, double d)
    : Value(1.0 / (d * d) + Inverse / (4.0 * area * area))
    , First(-2.0 / (d * d * d))
    , Second(6.0 / (d * d * d * d))
  {
  }
  static constexpr double Inverse = 0.1;
  double Value, First, Second; // and its derivatives
};
double GetDistortion(const TriangleShape& shape, const std::array<glm::dvec2, 3>& u);

/// Corners of a triangle in the plane.
std::array<glm::dvec2, 3> GetCorners(
  const TriangleTopology& mesh, const SurfaceParameters& parameters, int triangle);

int CountFlipped(const TriangleTopology& mesh, const SurfaceParameters& parameters);

/// Root mean square of the stretch, 1 where it is an isometry but for scale.
double GetStretch(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  const SurfaceParameters& parameters);

} // namespace bravais

#endif
