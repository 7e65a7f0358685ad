// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoldedCut.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

/// The walk round the tree, with the disk on the left.
class TreeWalk
{
public:
  TreeWalk(const TriangleTopology& mesh, const std::vector<int>& towards,
    const std::array<int, 4>& tips, const glm::dvec2& size)
    : Mesh(mesh)
    , Tips(tips)
    , Folds(GetFolds(size))
    , Tree(Index(mesh.GetNumberOfHalfEdges()), 0)
    , Places(Index(mesh.GetNumberOfVertices()))
    , Before(Index(mesh.GetNumberOfVertices()))
  {
    for (const int tip : tips)
    {
      for (int h = towards[Index(tip)]; h >= 0; h = towards[Index(mesh.GetOrigin(h))])
      {
        this->Tree[Index(h)] = Down;
        this->Tree[Index(mesh.GetTwin(h))] = Up;
      }
    }
  }

  FoldedCut Walk(int root)
  {
    this->Cut.Corners.assign(this->Tree.size(), HalfTurn());
    int start = this->Mesh.GetOutgoing(root);
    while (this->Tree[Index(start)] == 0)
    {
      start = this->Mesh.GetTwin(TriangleTopology::GetPrevious(start));
    }
    this->Visit(root);
    int h = start;
    do
    {
      this->Pass(h);
      h = this->Sweep(h);
    } while (h != start);
    return std::move(this->Cut);
  }

private:
  static constexpr char Down = 1; // away from the root
  static constexpr char Up = 2;

  /// A tip is met for the first time: from now on all that follows is turned about it.
  void Visit(int vertex)
  {
    if (std::find(this->Tips.begin(), this->Tips.end(), vertex) != this->Tips.end())
    {
      this->Product = GetHalfTurn(this->Folds[this->Found]) * this->Product;
      this->Cut.Tips[this->Found++] = vertex;
    }
  }

  /// Along a tree edge, to its end.
  void Pass(int h)
  {
    const std::size_t origin = Index(this->Mesh.GetOrigin(h));
    const std::size_t end = Index(this->Mesh.GetEnd(h));
    if (this->Tree[Index(h)] == Down)
    {
      this->Before[end] = this->Product;
      this->Visit(this->Mesh.GetEnd(h));
    }
    else
    {
      const HalfTurn turn = this->Product * this->Before[origin].Invert();
      this->Places[end] = turn * this->Places[end];
    }
  }

  /// The corners at its end, up to the next tree edge.
  int Sweep(int h)
  {
    const std::size_t end = Index(this->Mesh.GetEnd(h));
    int next = TriangleTopology::GetNext(h);
    for (;;)
    {
      this->Cut.Corners[Index(next)] = this->Places[end];
      if (this->Tree[Index(next)] != 0)
      {
        return next;
      }
      next = TriangleTopology::GetNext(this->Mesh.GetTwin(next));
    }
  }

  const TriangleTopology& Mesh;
  const std::array<int, 4>& Tips;
  const std::array<glm::dvec2, 4> Folds;
  std::vector<char> Tree;
  std::vector<HalfTurn> Places;
  std::vector<HalfTurn> Before;
  HalfTurn Product;
  std::size_t Found = 0;
  FoldedCut Cut;
};

} // namespace

//------------------------------------------------------------------------------
EdgeDistances FindEdgeDistances(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points,
  const std::vector<int>& sources)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  EdgeDistances result;
  result.Distances.assign(points.size(), std::numeric_limits<double>::infinity());
  result.HalfEdges.assign(points.size(), -1);
  for (const int source : sources)
  {
    result.Distances[Index(source)] = 0.0;
    queue.emplace(0.0, source);
  }
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > result.Distances[Index(vertex)])
    {
      continue;
    }
    const int first = mesh.GetOutgoing(vertex);
    int h = first;
    do
    {
      const int end = mesh.GetEnd(h);
      const double way = distance + glm::distance(points[Index(vertex)], points[Index(end)]);
      if (way < result.Distances[Index(end)])
      {
        result.Distances[Index(end)] = way;
        result.HalfEdges[Index(end)] = h;
        queue.emplace(way, end);
      }
      h = mesh.GetTwin(TriangleTopology::GetPrevious(h));
    } while (h != first);
  }
  return result;
}

//------------------------------------------------------------------------------
std::array<int, 4> FindTips(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points)
{
  const auto findFarthest = [&](const std::vector<int>& sources)
  {
    std::vector<double> distances = FindEdgeDistances(mesh, points, sources).Distances;
    for (double& distance : distances)
    {
      distance = distance < std::numeric_limits<double>::infinity() ? distance : -1.0;
    }
    for (const int source : sources)
    {
      distances[Index(source)] = -1.0;
    }
    return static_cast<int>(
      std::max_element(distances.begin(), distances.end()) - distances.begin());
  };
  std::vector<int> tips{ findFarthest({ mesh.GetOrigin(0) }) };
  while (tips.size() < 4)
  {
    tips.push_back(findFarthest(tips));
  }
  return { tips[0], tips[1], tips[2], tips[3] };
}

//------------------------------------------------------------------------------
FoldedCut CutToTips(const TriangleTopology& mesh, const std::vector<glm::dvec3>& points, int root,
  const std::array<int, 4>& tips, const glm::dvec2& size)
{
  const EdgeDistances ways = FindEdgeDistances(mesh, points, { root });
  return TreeWalk(mesh, ways.HalfEdges, tips, size).Walk(root);
}

} // namespace bravais
