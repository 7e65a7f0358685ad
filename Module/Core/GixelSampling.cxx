// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelSampling.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

using Corners = std::array<glm::dvec2, 3>;

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Draws triangles into the grid.
class Raster
{
public:
  Raster(const glm::dvec2& size, int width, int height)
    : Width(width)
    , Height(height)
    , Step(size / glm::dvec2(std::max(width - 1, 1), std::max(height - 1, 1)))
    , Samples(Index(width) * Index(height))
    , Depths(this->Samples.size(), -Tolerance)
  {
  }

  void Draw(int triangle, const Corners& u)
  {
    const glm::dvec2 low = glm::min(u[0], glm::min(u[1], u[2])) / this->Step - Tolerance;
    const glm::dvec2 high = glm::max(u[0], glm::max(u[1], u[2])) / this->Step + Tolerance;
    const int x0 = static_cast<int>(std::max(std::ceil(low.x), 0.0));
    const int y0 = static_cast<int>(std::max(std::ceil(low.y), 0.0));
    const int x1 = static_cast<int>(std::min(std::floor(high.x), this->Width - 1.0));
    const int y1 = static_cast<int>(std::min(std::floor(high.y), this->Height - 1.0));
    for (int y = y0; y <= y1; ++y)
    {
      for (int x = x0; x <= x1; ++x)
      {
        this->Claim(triangle, u, x, y);
      }
    }
  }

  void Claim(int triangle, const Corners& u, int x, int y)
  {
    const glm::dvec2 p = glm::dvec2(x, y) * this->Step;
    const double a = Cross(u[1] - p, u[2] - p);
    const double b = Cross(u[2] - p, u[0] - p);
    const double c = Cross(u[0] - p, u[1] - p);
    const double area = a + b + c;
    if (!(area > 0.0))
    {
      return;
    }
    const double depth = std::min({ a, b, c }) / area;
    const std::size_t gixel = Index(y) * Index(this->Width) + Index(x);
    if (depth > this->Depths[gixel])
    {
      this->Depths[gixel] = depth;
      const double total = std::max(a, 0.0) + std::max(b, 0.0) + std::max(c, 0.0);
      this->Samples[gixel] = { triangle,
        { { std::max(a, 0.0) / total, std::max(b, 0.0) / total, std::max(c, 0.0) / total } } };
    }
  }

  SurfaceSample& At(int x, int y)
  {
    return this->Samples[Index(y) * Index(this->Width) + Index(x)];
  }
  double& DepthAt(int x, int y) { return this->Depths[Index(y) * Index(this->Width) + Index(x)]; }

  /// Makes the edges the same from both ends.
  void Fold()
  {
    for (const int y : { 0, this->Height - 1 })
    {
      for (int x = 0; x < this->Width / 2; ++x)
      {
        this->At(this->Width - 1 - x, y) = this->At(x, y);
      }
    }
    for (const int x : { 0, this->Width - 1 })
    {
      for (int y = 0; y < this->Height / 2; ++y)
      {
        this->At(x, this->Height - 1 - y) = this->At(x, y);
      }
    }
  }

  static constexpr double Tolerance = 1e-9;
  int Width;
  int Height;
  glm::dvec2 Step;
  std::vector<SurfaceSample> Samples;
  std::vector<double> Depths;
};

/// Calls work(corners) for every place of a triangle that the rectangle may have.
template <class Work>
void ForEachPlace(const SurfaceParameters& parameters, const Corners& u, const Work& work)
{
  if (parameters.Corners.empty())
  {
    work(u);
    return;
  }
  // Places are u + (m w, n h) where m + n is even, and (m w, n h) - u where it is odd.
  constexpr double slack = 1e-9;
  for (const int odd : { 0, 1 })
  {
    const double sign = odd ? -1.0 : 1.0;
    const Corners s{ sign * u[0], sign * u[1], sign * u[2] };
    const glm::dvec2 low = glm::min(s[0], glm::min(s[1], s[2])) / parameters.Size;
    const glm::dvec2 high = glm::max(s[0], glm::max(s[1], s[2])) / parameters.Size;
    const glm::ivec2 first(glm::ceil(-high - slack));
    const glm::ivec2 last(glm::floor(1.0 - low + slack));
    for (int n = first.y; n <= last.y; ++n)
    {
      for (int m = first.x; m <= last.x; ++m)
      {
        if (((m + n) % 2 != 0) == (odd != 0))
        {
          const glm::dvec2 shift = glm::dvec2(m, n) * parameters.Size;
          work(Corners{ s[0] + shift, s[1] + shift, s[2] + shift });
        }
      }
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
std::vector<SurfaceSample> SampleSurface(
  const TriangleTopology& mesh, const SurfaceParameters& parameters, int width, int height)
{
  Raster raster(parameters.Size, width, height);
  const int triangles = static_cast<int>(mesh.GetTriangles().size());
  for (int t = 0; t < triangles; ++t)
  {
    ForEachPlace(
      parameters, GetCorners(mesh, parameters, t), [&](const Corners& u) { raster.Draw(t, u); });
  }
  // Rounding can leave a gixel between two triangles; the nearest one then has it.
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      if (raster.At(x, y).Triangle < 0)
      {
        raster.DepthAt(x, y) = -std::numeric_limits<double>::infinity();
        for (int t = 0; t < triangles; ++t)
        {
          ForEachPlace(parameters, GetCorners(mesh, parameters, t),
            [&](const Corners& u) { raster.Claim(t, u, x, y); });
        }
      }
    }
  }
  if (!parameters.Corners.empty())
  {
    raster.Fold();
  }
  return std::move(raster.Samples);
}

} // namespace bravais
