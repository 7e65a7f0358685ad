// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTopology.h"

#include <algorithm>
#include <numeric>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

/// Half-edges in the order of their edges' ends.
struct Edge
{
  int Low, High, HalfEdge;

  bool IsSame(const Edge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const Edge& other) const
  {
    return this->Low != other.Low ? this->Low < other.Low
      : this->High != other.High  ? this->High < other.High
                                  : this->HalfEdge < other.HalfEdge;
  }
};

} // namespace

//------------------------------------------------------------------------------
bool TriangleTopology::Set(int vertices, std::vector<Triangle> triangles, std::string& why)
{
  this->Vertices = vertices;
  this->Triangles = std::move(triangles);
  if (this->Triangles.empty())
  {
    why = "The mesh has no triangles with three different corners.";
    return false;
  }
  if (!this->PairHalfEdges(why) || !this->Orient(why) || !this->FindFans(why))
  {
    return false;
  }
  this->FindBoundaries();
  return true;
}

//------------------------------------------------------------------------------
bool TriangleTopology::PairHalfEdges(std::string& why)
{
  std::vector<Edge> edges;
  edges.reserve(Index(this->GetNumberOfHalfEdges()));
  for (int h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    edges.push_back({ std::min(this->GetOrigin(h), this->GetEnd(h)),
      std::max(this->GetOrigin(h), this->GetEnd(h)), h });
  }
  std::sort(edges.begin(), edges.end());
  this->Twins.assign(edges.size(), -1);
  int bad = 0;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last)
  {
    while (last < edges.size() && edges[last].IsSame(edges[first]))
    {
      ++last;
    }
    if (last - first == 2)
    {
      this->Twins[Index(edges[first].HalfEdge)] = edges[first + 1].HalfEdge;
      this->Twins[Index(edges[first + 1].HalfEdge)] = edges[first].HalfEdge;
    }
    bad += last - first > 2;
  }
  if (bad > 0)
  {
    why = "The mesh is not manifold: " + std::to_string(bad) +
      (bad == 1 ? " edge has" : " edges have") +
      " more than two triangles; at most two were expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool TriangleTopology::Orient(std::string& why)
{
  // 0 is unseen, 1 keeps its sense, -1 is turned.
  std::vector<signed char> sense(this->Triangles.size(), 0);
  std::vector<int> queue;
  int components = 0;
  for (std::size_t start = 0; start < sense.size(); ++start)
  {
    if (sense[start] != 0)
    {
      continue;
    }
    ++components;
    sense[start] = 1;
    queue.assign(1, static_cast<int>(start));
    while (!queue.empty())
    {
      const int triangle = queue.back();
      queue.pop_back();
      for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
      {
        const int twin = this->GetTwin(h);
        if (twin < 0)
        {
          continue;
        }
        const int same = this->GetOrigin(h) == this->GetEnd(twin) ? 1 : -1;
        const auto expected = static_cast<signed char>(sense[Index(triangle)] * same);
        if (sense[Index(twin / 3)] == 0)
        {
          sense[Index(twin / 3)] = expected;
          queue.push_back(twin / 3);
        }
        else if (sense[Index(twin / 3)] != expected)
        {
          why = "The mesh cannot be oriented: it has one side only; a disk or a closed surface of "
                "genus 0 was expected.";
          return false;
        }
      }
    }
  }
  if (components > 1)
  {
    why = "The mesh has " + std::to_string(components) + " components; 1 was expected.";
    return false;
  }
  const int sum = std::accumulate(sense.begin(), sense.end(), 0);
  for (std::size_t n = 0; n < sense.size(); ++n)
  {
    if (sense[n] != (sum >= 0 ? 1 : -1))
    {
      std::swap(this->Triangles[n][1], this->Triangles[n][2]);
    }
  }
  return this->PairHalfEdges(why);
}

//------------------------------------------------------------------------------
bool TriangleTopology::FindFans(std::string& why)
{
  this->Outgoing.assign(Index(this->Vertices), -1);
  std::vector<int> corners(Index(this->Vertices), 0);
  for (int h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    const std::size_t origin = Index(this->GetOrigin(h));
    ++corners[origin];
    if (this->Outgoing[origin] < 0 || this->GetTwin(h) < 0)
    {
      this->Outgoing[origin] = h;
    }
  }
  int bad = 0;
  for (int vertex = 0; vertex < this->Vertices; ++vertex)
  {
    int count = 0;
    int h = this->GetOutgoing(vertex);
    while (h >= 0)
    {
      ++count;
      h = this->GetTwin(GetPrevious(h));
      h = h == this->GetOutgoing(vertex) ? -1 : h;
    }
    bad += count != corners[Index(vertex)];
  }
  if (bad > 0)
  {
    why = "The mesh is not manifold: at " + std::to_string(bad) +
      (bad == 1 ? " vertex" : " vertices") +
      ", parts meet at a point alone; one fan of triangles "
      "round each vertex was expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void TriangleTopology::FindBoundaries()
{
  this->Boundaries.clear();
  std::vector<bool> seen(Index(this->Vertices), false);
  for (int start = 0; start < this->Vertices; ++start)
  {
    if (seen[Index(start)] || this->GetOutgoing(start) < 0 ||
      this->GetTwin(this->GetOutgoing(start)) >= 0)
    {
      continue;
    }
    std::vector<int>& boundary = this->Boundaries.emplace_back();
    for (int vertex = start; !seen[Index(vertex)]; vertex = this->GetEnd(this->GetOutgoing(vertex)))
    {
      seen[Index(vertex)] = true;
      boundary.push_back(vertex);
    }
  }
}

//------------------------------------------------------------------------------
int TriangleTopology::GetGenus() const
{
  int boundaryEdges = 0;
  for (const std::vector<int>& boundary : this->Boundaries)
  {
    boundaryEdges += static_cast<int>(boundary.size());
  }
  const int used = static_cast<int>(
    std::count_if(this->Outgoing.begin(), this->Outgoing.end(), [](int h) { return h >= 0; }));
  const int triangles = static_cast<int>(this->Triangles.size());
  const int edges = (3 * triangles + boundaryEdges) / 2;
  return (2 - this->GetNumberOfBoundaries() - (used - edges + triangles)) / 2;
}

} // namespace bravais
