// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GixelTriangles.h"

#include <optional>

namespace bravais
{

namespace
{

/// Corners of a cell in the image.
struct Corners
{
  int X0, X1, Y0, Y1;
};

template <class T>
T SquaredDistance(const GixelGrid<T>& grid, std::int64_t p, std::int64_t q)
{
  T sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const T d = grid.Points[3 * p + axis] - grid.Points[3 * q + axis];
    sum += d * d;
  }
  return sum;
}

/// Whether b c is shorter than a d.
template <class T>
bool IsSplitBC(const GixelGrid<T>& grid, const Corners& cell)
{
  return SquaredDistance(grid, grid.Index(cell.X1, cell.Y0), grid.Index(cell.X0, cell.Y1)) <
    SquaredDistance(grid, grid.Index(cell.X0, cell.Y0), grid.Index(cell.X1, cell.Y1));
}

/// Triangles all of whose gixels, corners and border included, are used.
template <class T>
unsigned FindWholeTriangles(const GixelGrid<T>& grid, const Corners& cell, bool splitBC)
{
  const std::int64_t w = cell.X1 - cell.X0;
  const std::int64_t h = cell.Y1 - cell.Y0;
  unsigned whole = FirstTriangle | SecondTriangle;
  for (int y = cell.Y0; y <= cell.Y1; ++y)
  {
    for (int x = cell.X0; x <= cell.X1; ++x)
    {
      if (!grid.IsUsed(x, y))
      {
        const std::int64_t u = (x - cell.X0) * h;
        const std::int64_t v = (y - cell.Y0) * w;
        const std::int64_t side = splitBC ? w * h - u - v : u - v; // positive in the first triangle
        whole &= side > 0 ? ~FirstTriangle : ~0U;
        whole &= side < 0 ? ~SecondTriangle : ~0U;
        whole = side == 0 ? 0U : whole;
      }
    }
  }
  return whole;
}

template <class T>
bool IsWhole(const GixelGrid<T>& grid, const Corners& cell)
{
  for (int y = cell.Y0; grid.Used && y <= cell.Y1; ++y)
  {
    for (int x = cell.X0; x <= cell.X1; ++x)
    {
      if (!grid.IsUsed(x, y))
      {
        return false;
      }
    }
  }
  return true;
}

/// The bits without a look at the mask.
template <class T>
unsigned ClassifyCell(const GixelGrid<T>& grid, const Corners& cell)
{
  if (IsWhole(grid, cell))
  {
    return FirstTriangle | SecondTriangle | (IsSplitBC(grid, cell) ? SplitBC : 0U);
  }
  const bool a = grid.IsUsed(cell.X0, cell.Y0);
  const bool b = grid.IsUsed(cell.X1, cell.Y0);
  const bool c = grid.IsUsed(cell.X0, cell.Y1);
  const bool d = grid.IsUsed(cell.X1, cell.Y1);
  if (a + b + c + d < 3)
  {
    return 0U;
  }
  const bool all = a && b && c && d;
  const bool splitBC = all ? IsSplitBC(grid, cell) : b && c;
  return FindWholeTriangles(grid, cell, splitBC) | (splitBC ? SplitBC : 0U);
}

/// Those of a cell's triangles that have a set corner.
unsigned SelectTriangles(const unsigned char* corner, std::int64_t columns, unsigned cell)
{
  const bool splitBC = (cell & SplitBC) != 0U;
  for (const unsigned triangle : { FirstTriangle, SecondTriangle })
  {
    const GixelTriangle t = GetGixelTriangle(0, columns, splitBC, triangle == SecondTriangle);
    if (!corner[t[0]] && !corner[t[1]] && !corner[t[2]])
    {
      cell &= ~triangle;
    }
  }
  return cell;
}

/// A row's triangles from left to right, each of which shares an edge with the next.
std::vector<GixelTriangle> ListTriangles(const unsigned char* cells, std::int64_t columns, int row)
{
  std::vector<GixelTriangle> triangles;
  for (std::int64_t column = 0; column + 1 < columns; ++column)
  {
    const bool splitBC = (cells[column] & SplitBC) != 0;
    for (const bool second : { !splitBC, splitBC }) // of a d, the triangle with c comes first
    {
      if (cells[column] & (second ? SecondTriangle : FirstTriangle))
      {
        triangles.push_back(GetGixelTriangle(row * columns + column, columns, splitBC, second));
      }
    }
  }
  return triangles;
}

/// The corner by which a triangle is number k of a strip whose last corners are these: triangle k
/// of a strip v is v[k], v[k + 1], v[k + 2], every second one turned round.
std::optional<std::int64_t> FindNext(
  const GixelTriangle& triangle, std::int64_t former, std::int64_t last, std::size_t k)
{
  const std::int64_t from = k % 2 == 0 ? former : last;
  const std::int64_t to = k % 2 == 0 ? last : former;
  for (std::size_t n = 0; n < 3; ++n)
  {
    if (triangle[n] == from && triangle[(n + 1) % 3] == to)
    {
      return triangle[(n + 2) % 3];
    }
  }
  return std::nullopt;
}

/// How many triangles are a strip that starts with this corner of the first.
struct Run
{
  std::size_t Turn;
  std::size_t Length;
};

Run FindLongestRun(const std::vector<GixelTriangle>& triangles, std::size_t begin)
{
  Run longest{ 0, 0 };
  for (std::size_t turn = 0; turn < 3 && begin < triangles.size(); ++turn)
  {
    std::int64_t former = triangles[begin][(turn + 1) % 3];
    std::int64_t last = triangles[begin][(turn + 2) % 3];
    std::size_t length = 1;
    for (; begin + length < triangles.size(); ++length)
    {
      const auto next = FindNext(triangles[begin + length], former, last, length);
      if (!next)
      {
        break;
      }
      former = last;
      last = *next;
    }
    longest = length > longest.Length ? Run{ turn, length } : longest;
  }
  return longest;
}

} // namespace

//------------------------------------------------------------------------------
template <class T>
std::int64_t ClassifyGixelCells(const GixelGrid<T>& grid, const GixelLevel& level,
  const unsigned char* mask, int row, unsigned char* cells)
{
  const int columns = level.Columns.Count();
  std::int64_t count = 0;
  for (int column = 0; column + 1 < columns; ++column)
  {
    unsigned cell = 0U;
    const unsigned char* corner = mask ? mask + std::int64_t{ row } * columns + column : nullptr;
    if (!mask || corner[0] || corner[1] || corner[columns] || corner[columns + 1])
    {
      cell = ClassifyCell(grid,
        { level.Columns[column], level.Columns[column + 1], level.Rows[row], level.Rows[row + 1] });
      cell = mask ? SelectTriangles(corner, columns, cell) : cell;
    }
    cells[column] = static_cast<unsigned char>(cell);
    count += (cell & FirstTriangle) + (cell & SecondTriangle) / SecondTriangle;
  }
  return count;
}

template std::int64_t ClassifyGixelCells<float>(
  const GixelGrid<float>&, const GixelLevel&, const unsigned char*, int, unsigned char*);
template std::int64_t ClassifyGixelCells<double>(
  const GixelGrid<double>&, const GixelLevel&, const unsigned char*, int, unsigned char*);

//------------------------------------------------------------------------------
void AppendGixelStrips(const unsigned char* cells, std::int64_t columns, int row,
  std::vector<std::int64_t>& lengths, std::vector<std::int64_t>& gixels)
{
  const std::vector<GixelTriangle> triangles = ListTriangles(cells, columns, row);
  std::size_t n = 0;
  Run run = FindLongestRun(triangles, n);
  while (run.Length > 0)
  {
    const Run following = FindLongestRun(triangles, n + 1);
    if (following.Length > run.Length)
    {
      run.Length = 1; // a triangle of its own, for the sake of what follows
    }
    const GixelTriangle& first = triangles[n];
    gixels.insert(
      gixels.end(), { first[run.Turn], first[(run.Turn + 1) % 3], first[(run.Turn + 2) % 3] });
    for (std::size_t k = 1; k < run.Length; ++k)
    {
      gixels.push_back(*FindNext(triangles[n + k], gixels[gixels.size() - 2], gixels.back(), k));
    }
    lengths.push_back(static_cast<std::int64_t>(run.Length) + 2);
    n += run.Length;
    run = FindLongestRun(triangles, n);
  }
}

} // namespace bravais
