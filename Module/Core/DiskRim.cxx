// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DiskRim.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

/// By how much the rim turns to the left at its vertices.
std::vector<double> GetTurns(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points)
{
  std::vector<double> angles(points.size(), 0.0);
  for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const glm::dvec3& p = points[Index(mesh.GetOrigin(h))];
    const glm::dvec3 a = points[Index(mesh.GetEnd(h))] - p;
    const glm::dvec3 b = points[Index(mesh.GetOrigin(TriangleTopology::GetPrevious(h)))] - p;
    angles[Index(mesh.GetOrigin(h))] += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  std::vector<double> turns;
  for (const int vertex : mesh.GetBoundary(0))
  {
    turns.push_back(glm::pi<double>() - angles[Index(vertex)]);
  }
  return turns;
}

/// Lengths along the rim up to each of its vertices, and the whole.
std::vector<double> GetLengths(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points)
{
  const std::vector<int>& rim = mesh.GetBoundary(0);
  std::vector<double> lengths{ 0.0 };
  for (std::size_t n = 0; n < rim.size(); ++n)
  {
    lengths.push_back(lengths.back() +
      glm::distance(points[Index(rim[n])], points[Index(rim[(n + 1) % rim.size()])]));
  }
  return lengths;
}

/// Places on the rim of the sharpest turns; fewer than four if there are not so many.
std::vector<std::size_t> FindSharpTurns(
  const std::vector<double>& turns, const std::vector<double>& lengths)
{
  constexpr double least = glm::pi<double>() / 6.0;
  const double apart = lengths.back() / 12.0;
  std::vector<std::size_t> order(turns.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return turns[a] > turns[b] + 1e-9; });
  std::vector<std::size_t> found;
  for (const std::size_t n : order)
  {
    const bool far = std::all_of(found.begin(), found.end(),
      [&](std::size_t other)
      {
        const double way = std::abs(lengths[n] - lengths[other]);
        return std::min(way, lengths.back() - way) >= apart;
      });
    if (found.size() < 4 && far && turns[n] >= least)
    {
      found.push_back(n);
    }
  }
  return found;
}

/// Places on the rim nearest to its quarters, all different.
std::vector<std::size_t> FindQuarters(std::size_t start, const std::vector<double>& lengths)
{
  const std::size_t count = lengths.size() - 1;
  std::vector<std::size_t> steps{ 0 };
  std::vector<std::size_t> found{ start };
  for (std::size_t side = 1; side < 4; ++side)
  {
    const double wanted = lengths.back() * static_cast<double>(side) / 4.0;
    std::size_t best = steps.back() + 1;
    double least = lengths.back();
    for (std::size_t step = best; step + 3 - side < count; ++step)
    {
      double way = lengths[(start + step) % count] - lengths[start];
      way += start + step >= count ? lengths.back() : 0.0;
      if (std::abs(way - wanted) < least)
      {
        least = std::abs(way - wanted);
        best = step;
      }
    }
    steps.push_back(best);
    found.push_back((start + best) % count);
  }
  return found;
}

/// Sides of the rectangle that each vertex is on, as bits.
std::vector<unsigned char> FindSides(
  const TriangleTopology& mesh, const std::array<int, 4>& corners)
{
  const std::vector<int>& rim = mesh.GetBoundary(0);
  std::vector<unsigned char> sides(Index(mesh.GetNumberOfVertices()), 0);
  std::size_t n =
    static_cast<std::size_t>(std::find(rim.begin(), rim.end(), corners[0]) - rim.begin());
  for (unsigned side = 0; side < 4; ++side)
  {
    const auto bit = static_cast<unsigned char>(1U << side);
    sides[Index(rim[n])] |= bit;
    do
    {
      n = (n + 1) % rim.size();
      sides[Index(rim[n])] |= bit;
    } while (rim[n] != corners[(side + 1) % 4]);
  }
  return sides;
}

} // namespace

//------------------------------------------------------------------------------
std::array<int, 4> FindRimCorners(
  const TriangleTopology& mesh, const std::vector<glm::dvec3>& points)
{
  const std::vector<int>& rim = mesh.GetBoundary(0);
  const std::vector<double> turns = GetTurns(mesh, points);
  const std::vector<double> lengths = GetLengths(mesh, points);
  std::vector<std::size_t> found = FindSharpTurns(turns, lengths);
  if (found.size() < 4)
  {
    found = FindQuarters(found.empty() ? 0 : found[0], lengths);
  }
  std::sort(found.begin(), found.end());
  std::array<int, 4> corners{};
  std::transform(
    found.begin(), found.end(), corners.begin(), [&](std::size_t n) { return rim[n]; });
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

//------------------------------------------------------------------------------
std::vector<Ends> FindChords(const TriangleTopology& mesh, const std::array<int, 4>& corners)
{
  const std::vector<unsigned char> sides = FindSides(mesh, corners);
  std::vector<Ends> chords;
  for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const int from = mesh.GetOrigin(h);
    const int to = mesh.GetEnd(h);
    if (mesh.GetTwin(h) > h && (sides[Index(from)] & sides[Index(to)]) != 0)
    {
      chords.push_back({ { from, to } });
    }
  }
  return chords;
}

//------------------------------------------------------------------------------
std::vector<Triangle> SplitEdges(const TriangleTopology& mesh, const std::vector<Ends>& edges)
{
  std::map<Ends, int> middles;
  for (const Ends& edge : edges)
  {
    const int middle = mesh.GetNumberOfVertices() + static_cast<int>(middles.size());
    middles[{ { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) } }] = middle;
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.GetTriangles())
  {
    Triangle middle{ { -1, -1, -1 } }; // after each corner
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int next = t[(k + 1) % 3];
      const auto found = middles.find({ { std::min(t[k], next), std::max(t[k], next) } });
      middle[k] = found != middles.end() ? found->second : -1;
      count += middle[k] >= 0;
    }
    // Turned so that the first edges are the split ones.
    std::size_t first = 0;
    while (count < 3 && count > 0 && (middle[first] < 0 || middle[(first + 2) % 3] >= 0))
    {
      ++first;
    }
    const int a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
    const int p = middle[first], q = middle[(first + 1) % 3], r = middle[(first + 2) % 3];
    if (count == 0)
    {
      triangles.push_back(t);
    }
    else if (count == 1)
    {
      triangles.insert(triangles.end(), { { { a, p, c } }, { { p, b, c } } });
    }
    else if (count == 2)
    {
      triangles.insert(triangles.end(), { { { p, b, q } }, { { a, p, q } }, { { a, q, c } } });
    }
    else
    {
      triangles.insert(
        triangles.end(), { { { a, p, r } }, { { p, b, q } }, { { q, c, r } }, { { p, q, r } } });
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
SurfaceParameters LayRim(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points,
  const std::array<int, 4>& corners, const glm::dvec2& size)
{
  const glm::dvec2 places[5] = { { 0.0, 0.0 }, { size.x, 0.0 }, size, { 0.0, size.y },
    { 0.0, 0.0 } };
  SurfaceParameters parameters;
  parameters.Size = size;
  parameters.Fixed.assign(points.size(), 0);
  parameters.Places.assign(points.size(), 0.5 * size);
  const std::vector<int>& rim = mesh.GetBoundary(0);
  std::size_t n =
    static_cast<std::size_t>(std::find(rim.begin(), rim.end(), corners[0]) - rim.begin());
  for (std::size_t side = 0; side < 4; ++side)
  {
    std::vector<int> vertices{ rim[n] };
    std::vector<double> lengths{ 0.0 };
    do
    {
      n = (n + 1) % rim.size();
      lengths.push_back(
        lengths.back() + glm::distance(points[Index(vertices.back())], points[Index(rim[n])]));
      vertices.push_back(rim[n]);
    } while (rim[n] != corners[(side + 1) % 4]);
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
    {
      const double part = lengths[k] / lengths.back();
      parameters.Fixed[Index(vertices[k])] = 1;
      parameters.Places[Index(vertices[k])] =
        places[side] + part * (places[side + 1] - places[side]);
    }
  }
  return parameters;
}

} // namespace bravais
