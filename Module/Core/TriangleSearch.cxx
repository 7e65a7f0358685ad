// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleSearch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

constexpr std::uint32_t None = CellGrid::NoCell;

double GetSquaredDistance(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::dot(b - a, b - a);
}

void Extend(Box& box, const Box& other)
{
  box.Low = glm::min(box.Low, other.Low);
  box.High = glm::max(box.High, other.High);
}

/// T. Moeller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
bool MeetTriangle(const glm::dvec3& from, const glm::dvec3& along, const glm::dvec3 corner[3],
  double& parameter, glm::dvec3& weights)
{
  const glm::dvec3 e1 = corner[1] - corner[0];
  const glm::dvec3 e2 = corner[2] - corner[0];
  const glm::dvec3 p = glm::cross(along, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0)
  {
    return false; // parallel, or no triangle
  }
  const glm::dvec3 s = from - corner[0];
  const glm::dvec3 q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant;
  const double v = glm::dot(along, q) / determinant;
  constexpr double rounding = 1e-12; // so that no line passes between two triangles
  parameter = glm::dot(e2, q) / determinant;
  weights = { 1.0 - u - v, u, v };
  return u >= -rounding && v >= -rounding && u + v <= 1.0 + rounding && parameter >= 0.0 &&
    parameter <= 1.0;
}

} // namespace

//------------------------------------------------------------------------------
TriangleSearch::TriangleSearch(
  const GixelOctree& tree, std::uint32_t width, std::uint32_t height, const Positions& positions)
  : Tree(tree)
  , Width(width)
  , Height(height)
  , LeafOf(std::size_t{ width } * height, None)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Box empty{ glm::dvec3(infinity), glm::dvec3(-infinity) };
  for (int depth = 0; depth <= tree.GetDepth(); ++depth)
  {
    this->Boxes.emplace_back(tree.GetLevel(depth).GetSize(), empty);
  }
  const GixelOctree::Level& leaves = tree.GetLeaves();
  for (std::uint32_t leaf = 0; leaf < leaves.GetSize(); ++leaf)
  {
    for (std::uint32_t place = leaves.Gixels[leaf]; place < leaves.Gixels[leaf + 1]; ++place)
    {
      this->LeafOf[tree.GetGixels()[place]] = leaf;
    }
  }
  for (std::uint32_t row = 0; row + 1 < height; ++row)
  {
    for (std::uint32_t column = 0; column + 1 < width; ++column)
    {
      this->AddToLeaf(row * width + column, positions);
    }
  }
  for (int depth = tree.GetDepth() - 1; depth >= 0; --depth)
  {
    const GixelOctree::Level& level = tree.GetLevel(depth);
    const auto above = static_cast<std::size_t>(depth);
    for (std::uint32_t node = 0; node < level.GetSize(); ++node)
    {
      for (std::uint32_t child = level.Children[node]; child < level.Children[node + 1]; ++child)
      {
        Extend(this->Boxes[above][node], this->Boxes[above + 1][child]);
      }
    }
  }
}

//------------------------------------------------------------------------------
int TriangleSearch::GetTriangles(
  std::uint32_t corner, const Positions& positions, std::array<Triangle, 2>& triangles) const
{
  const std::uint32_t a = corner;
  const std::uint32_t b = corner + 1;
  const std::uint32_t c = corner + this->Width;
  const std::uint32_t d = c + 1;
  const bool used[4] = { this->LeafOf[a] != None, this->LeafOf[b] != None, this->LeafOf[c] != None,
    this->LeafOf[d] != None };
  const int count = used[0] + used[1] + used[2] + used[3];
  if (count < 3)
  {
    return 0;
  }
  if (count == 3)
  {
    triangles[0] = !used[0] ? Triangle{ b, d, c }
      : !used[1]            ? Triangle{ a, d, c }
      : !used[2]            ? Triangle{ a, b, d }
                            : Triangle{ a, b, c };
    return 1;
  }
  const bool ad = GetSquaredDistance(positions(a), positions(d)) <=
    GetSquaredDistance(positions(b), positions(c));
  triangles[0] = ad ? Triangle{ a, b, d } : Triangle{ a, b, c };
  triangles[1] = ad ? Triangle{ a, d, c } : Triangle{ b, d, c };
  return 2;
}

//------------------------------------------------------------------------------
bool TriangleSearch::IsOwner(std::uint32_t gixel, std::uint32_t corner) const
{
  for (const std::uint32_t other :
    { corner, corner + 1, corner + this->Width, corner + this->Width + 1 })
  {
    if (this->LeafOf[other] != None)
    {
      return other == gixel;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TriangleSearch::AddToLeaf(std::uint32_t corner, const Positions& positions)
{
  std::array<Triangle, 2> triangles;
  const int count = this->GetTriangles(corner, positions, triangles);
  for (const std::uint32_t owner :
    { corner, corner + 1, corner + this->Width, corner + this->Width + 1 })
  {
    if (count && this->IsOwner(owner, corner))
    {
      Box& box = this->Boxes.back()[this->LeafOf[owner]];
      for (int n = 0; n < count; ++n)
      {
        for (const std::uint32_t gixel : triangles[static_cast<std::size_t>(n)])
        {
          const glm::dvec3 point = positions(gixel);
          Extend(box, { point, point });
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
std::optional<TriangleSearch::Hit> TriangleSearch::Intersect(
  const glm::dvec3& from, const glm::dvec3& to, const Positions& positions) const
{
  const SegmentTest line(from, to);
  std::optional<Hit> first;
  const auto tryCorner = [&](std::uint32_t corner)
  {
    std::array<Triangle, 2> triangles;
    const int count = this->GetTriangles(corner, positions, triangles);
    for (int n = 0; n < count; ++n)
    {
      const Triangle& triangle = triangles[static_cast<std::size_t>(n)];
      const glm::dvec3 points[3] = { positions(triangle[0]), positions(triangle[1]),
        positions(triangle[2]) };
      Hit hit{ 0.0, {}, triangle, {} };
      if (MeetTriangle(from, to - from, points, hit.Parameter, hit.Weights) &&
        (!first || hit.Parameter < first->Parameter))
      {
        hit.Point = from + hit.Parameter * (to - from);
        first = hit;
      }
    }
  };
  const auto tryGixel = [&](std::uint32_t gixel)
  {
    const std::uint32_t column = gixel % this->Width;
    const std::uint32_t row = gixel / this->Width;
    for (std::uint32_t up = 0; up < 2; ++up)
    {
      for (std::uint32_t left = 0; left < 2; ++left)
      {
        const bool inside = column >= left && row >= up && column - left + 1 < this->Width &&
          row - up + 1 < this->Height;
        const std::uint32_t corner = gixel - left - up * this->Width;
        if (inside && this->IsOwner(gixel, corner))
        {
          tryCorner(corner);
        }
      }
    }
  };
  std::vector<OctreeNode> stack;
  if (!this->Boxes.front().empty())
  {
    stack.push_back({ 0, 0 });
  }
  while (!stack.empty())
  {
    const OctreeNode node = stack.back();
    stack.pop_back();
    const Box& box = this->Boxes[static_cast<std::size_t>(node.Depth)][node.Index];
    if (box.Low.x > box.High.x || !line.Meets(box, first ? first->Parameter : 1.0))
    {
      continue;
    }
    const GixelOctree::Level& level = this->Tree.GetLevel(node.Depth);
    if (node.Depth == this->Tree.GetDepth())
    {
      for (std::uint32_t n = level.Gixels[node.Index]; n < level.Gixels[node.Index + 1]; ++n)
      {
        tryGixel(this->Tree.GetGixels()[n]);
      }
      continue;
    }
    for (std::uint32_t n = level.Children[node.Index]; n < level.Children[node.Index + 1]; ++n)
    {
      stack.push_back({ node.Depth + 1, n });
    }
  }
  return first;
}

} // namespace bravais
