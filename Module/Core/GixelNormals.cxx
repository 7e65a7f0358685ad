// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelNormals.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace bravais
{

namespace
{

template <class T>
glm::dvec3 GetPoint(const GixelGrid<T>& grid, std::int64_t index)
{
  const T* p = grid.Points + 3 * index;
  return { p[0], p[1], p[2] };
}

/// Whether two rows or columns of gixels, given by their first and a step, are used and the same.
template <class T>
bool AreSame(const GixelGrid<T>& grid, std::int64_t first, std::int64_t step, std::int64_t other,
  std::int64_t otherStep, int count)
{
  for (int n = 0; n < count; ++n)
  {
    const std::int64_t p = first + n * step;
    const std::int64_t q = other + n * otherStep;
    if ((grid.Used && (!grid.Used[p] || !grid.Used[q])) || GetPoint(grid, p) != GetPoint(grid, q))
    {
      return false;
    }
  }
  return true;
}

/// Scaled to length 1 if it is neither zero nor beyond double.
bool Normalize(glm::dvec3& v)
{
  const double length = std::hypot(v.x, v.y, v.z);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return false;
  }
  v /= length;
  return true;
}

/// Twice the areas' vectors of the triangles between a gixel and the ring round it.
template <class T>
glm::dvec3 SumRing(const GixelGrid<T>& grid, const GixelSeams<T>& seams, int column, int row)
{
  constexpr int ring[9][2] = { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { -1, -1 },
    { 0, -1 }, { 1, -1 }, { 1, 0 } };
  const glm::dvec3 center = GetPoint(grid, grid.Index(column, row));
  glm::dvec3 sum(0.0);
  for (int n = 0; n < 8; ++n)
  {
    const auto p = seams.Find(column + ring[n][0], row + ring[n][1]);
    const auto q = seams.Find(column + ring[n + 1][0], row + ring[n + 1][1]);
    if (p && q)
    {
      sum += glm::cross(GetPoint(grid, *p) - center, GetPoint(grid, *q) - center);
    }
  }
  return sum;
}

} // namespace

//------------------------------------------------------------------------------
template <class T>
GixelSeams<T>::GixelSeams(const GixelGrid<T>& grid)
  : Grid(grid)
{
  const int w = grid.Width;
  const int h = grid.Height;
  const std::int64_t right = w - 1;
  const std::int64_t top = grid.Index(0, h - 1);
  this->JoinedColumns = w > 2 && AreSame(grid, 0, w, right, w, h);
  this->JoinedRows = h > 2 && AreSame(grid, 0, 1, top, 1, w);
  this->FoldedColumns[0] = w > 1 && AreSame(grid, 0, w, top, -w, h);
  this->FoldedColumns[1] = w > 1 && AreSame(grid, right, w, top + right, -w, h);
  this->FoldedRows[0] = h > 1 && AreSame(grid, 0, 1, right, -1, w);
  this->FoldedRows[1] = h > 1 && AreSame(grid, top, 1, top + right, -1, w);
}

//------------------------------------------------------------------------------
template <class T>
std::optional<std::int64_t> GixelSeams<T>::Find(int column, int row) const
{
  const int w = this->Grid.Width;
  const int h = this->Grid.Height;
  if (column < 0 || column >= w)
  {
    if (this->JoinedColumns)
    {
      column += column < 0 ? w - 1 : 1 - w;
    }
    else if (this->FoldedColumns[column < 0 ? 0 : 1])
    {
      column = column < 0 ? 1 : w - 2;
      row = h - 1 - row;
    }
    else
    {
      return std::nullopt;
    }
  }
  if (row < 0 || row >= h)
  {
    if (this->JoinedRows)
    {
      row += row < 0 ? h - 1 : 1 - h;
    }
    else if (this->FoldedRows[row < 0 ? 0 : 1])
    {
      row = row < 0 ? 1 : h - 2;
      column = w - 1 - column;
    }
    else
    {
      return std::nullopt;
    }
  }
  return this->Grid.IsUsed(column, row) ? std::optional(this->Grid.Index(column, row))
                                        : std::nullopt;
}

//------------------------------------------------------------------------------
template <class T>
glm::dvec3 GetGixelNormal(const GixelGrid<T>& grid, const GixelSeams<T>& seams, int column, int row)
{
  const auto getDifference = [&](int x, int y)
  {
    const std::int64_t self = grid.Index(column, row);
    const auto next = seams.Find(column + x, row + y);
    const auto former = seams.Find(column - x, row - y);
    return GetPoint(grid, next.value_or(self)) - GetPoint(grid, former.value_or(self));
  };
  glm::dvec3 normal = glm::cross(getDifference(1, 0), getDifference(0, 1));
  if (!Normalize(normal))
  {
    normal = SumRing(grid, seams, column, row);
    normal = Normalize(normal) ? normal : glm::dvec3(0.0, 0.0, 1.0);
  }
  return normal;
}

template class GixelSeams<float>;
template class GixelSeams<double>;
template glm::dvec3 GetGixelNormal(const GixelGrid<float>&, const GixelSeams<float>&, int, int);
template glm::dvec3 GetGixelNormal(const GixelGrid<double>&, const GixelSeams<double>&, int, int);

} // namespace bravais
