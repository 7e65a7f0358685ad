// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellCoverage_h
#define CellCoverage_h

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bravais
{

/**
 * How much of each pixel a convex hexagon covers, wherever it is moved to.
 *
 * The area of a polygon in a pixel is the sum over its edges of the integrals of how far the edge
 * is into the pixel, dy upwards and -dy downwards. So each edge is cut where it enters other rows
 * and columns, and what a piece says of all pixels to its left is added up along the row. That
 * takes as many steps as the outline crosses pixels, and the areas are exact to rounding. One row
 * after the other needs memory for one.
 */
class CellCoverage
{
public:
  /// Corners counter-clockwise, relative to the centre, in pixels; two may be equal.
  explicit CellCoverage(const std::array<glm::dvec2, 6>& corners)
    : Low(corners[0])
    , High(corners[0])
  {
    for (int i = 0; i < 6; ++i)
    {
      const glm::dvec2 a = corners[i];
      const glm::dvec2 b = corners[(i + 1) % 6];
      this->Low = { std::min(this->Low.x, a.x), std::min(this->Low.y, a.y) };
      this->High = { std::max(this->High.x, a.x), std::max(this->High.y, a.y) };
      this->Area += 0.5 * (a.x * b.y - a.y * b.x);
      if (a.y != b.y)
      {
        Edge& edge = this->Edges[this->NumberOfEdges++];
        edge.Bottom = a.y < b.y ? a : b;
        edge.Top = a.y < b.y ? b : a;
        edge.Slope = (edge.Top.x - edge.Bottom.x) / (edge.Top.y - edge.Bottom.y);
        edge.Sign = a.y < b.y ? 1.0 : -1.0;
      }
    }
    this->Scale = 1.0 / this->Area;
  }

  double GetArea() const { return this->Area; }

  /// What ForEachRow works in; one for each thread.
  using Row = std::vector<double>;
  Row MakeRow() const
  {
    return Row(2 * (static_cast<std::size_t>(this->High.x - this->Low.x) + 4), 0.0);
  }

  /// Calls work(y, x, count, weights) for every row y of pixels that the cell at `center` overlaps,
  /// from the bottom up. Pixels x .. x + count - 1 have the weights, which sum to 1 over all rows.
  template <class Work>
  void ForEachRow(const glm::dvec2& center, Row& row, const Work& work) const
  {
    // From here on relative to the corner of the first pixel, so that all numbers are positive.
    const int left = RoundDown(center.x + this->Low.x);
    const int bottom = RoundDown(center.y + this->Low.y);
    const glm::dvec2 offset(center.x - left, center.y - bottom);
    const int count = static_cast<int>(offset.x + this->High.x) + 1;
    const double top = offset.y + this->High.y;
    double* inside = row.data();
    double* beyond = inside + count + 1;
    for (int y = 0; y < top; ++y)
    {
      std::fill_n(inside, 2 * (count + 1), 0.0);
      for (int i = 0; i < this->NumberOfEdges; ++i)
      {
        this->CutEdge(this->Edges[i], offset, y, inside, beyond);
      }
      double sum = 0.0;
      for (int x = count - 1; x >= 0; --x)
      {
        inside[x] = (inside[x] + sum) * this->Scale;
        sum += beyond[x];
      }
      work(bottom + y, left, count, inside);
    }
  }

private:
  struct Edge
  {
    glm::dvec2 Bottom;
    glm::dvec2 Top;
    double Slope; ///< dx / dy
    double Sign;  ///< 1 where the cell is to the left
  };

  /// std::floor, without a call.
  static int RoundDown(double x)
  {
    const int whole = static_cast<int>(x);
    return whole - (whole > x ? 1 : 0);
  }

  /// Adds the part of an edge that lies in row y.
  static void CutEdge(
    const Edge& edge, const glm::dvec2& offset, int y, double* inside, double* beyond)
  {
    const double bottom = edge.Bottom.y + offset.y;
    const double top = edge.Top.y + offset.y;
    if (top <= y || bottom >= y + 1)
    {
      return;
    }
    // An end in the row is taken as it is: a neighbour's edge ends in the same number.
    const double from = bottom > y ? bottom : y;
    const double to = top < y + 1 ? top : y + 1;
    const double x = edge.Bottom.x + offset.x;
    double a = bottom > y ? x : std::max(0.0, x + edge.Slope * (from - bottom));
    double b = top < y + 1 ? edge.Top.x + offset.x : std::max(0.0, x + edge.Slope * (to - bottom));
    if (a > b)
    {
      std::swap(a, b);
    }
    const double height = (to - from) * edge.Sign;
    const int first = static_cast<int>(a);
    const int last = static_cast<int>(b);
    if (first == last)
    {
      inside[first] += height * (0.5 * (a + b) - first);
      beyond[first] += height;
      return;
    }
    const double perColumn = height / (b - a);
    for (int column = first; column <= last; ++column)
    {
      const double begin = std::max(a, static_cast<double>(column));
      const double end = std::min(b, column + 1.0);
      const double part = perColumn * (end - begin);
      inside[column] += part * (0.5 * (begin + end) - column);
      beyond[column] += part;
    }
  }

  std::array<Edge, 6> Edges;
  int NumberOfEdges = 0;
  glm::dvec2 Low;
  glm::dvec2 High;
  double Area = 0.0;
  double Scale = 1.0;
};

} // namespace bravais

#endif
