// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeTest.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bravais
{

namespace
{

constexpr double Rounding = 1e-13; // of the terms, more than a few operations' rounding

double Evaluate(const PlanesTest::Plane& plane, const glm::dvec3& x)
{
  const glm::dvec3 term = plane.Normal * (x - plane.Origin);
  return term.x + term.y + term.z + plane.Offset;
}

/// The corner of a cell that is farthest along a direction.
glm::dvec3 GetCorner(const Box& cell, const glm::dvec3& direction)
{
  return { direction.x > 0.0 ? cell.High.x : cell.Low.x,
    direction.y > 0.0 ? cell.High.y : cell.Low.y, direction.z > 0.0 ? cell.High.z : cell.Low.z };
}

double GetTolerance(const PlanesTest::Plane& plane, const Box& cell)
{
  if (plane.Exact)
  {
    return 0.0;
  }
  const glm::dvec3 farthest = glm::max(glm::abs(cell.Low), glm::abs(cell.High));
  return Rounding *
    (glm::dot(glm::abs(plane.Normal), farthest + glm::abs(plane.Origin)) + std::abs(plane.Offset));
}

/// Solves m x = b for the unknowns of a bit set, by elimination; false if m is singular there.
bool SolveFor(unsigned int unknowns, glm::dmat3 m, glm::dvec3& b)
{
  const double scale = std::max({ m[0][0], m[1][1], m[2][2] });
  for (int pivot = 0; pivot < 3; ++pivot)
  {
    if (!(unknowns >> pivot & 1))
    {
      continue;
    }
    if (!(m[pivot][pivot] > 1e-14 * scale)) // m is symmetric and has no negative pivots
    {
      return false;
    }
    for (int row = 0; row < 3; ++row)
    {
      if (row != pivot && (unknowns >> row & 1))
      {
        const double factor = m[pivot][row] / m[pivot][pivot];
        for (int column = 0; column < 3; ++column)
        {
          m[column][row] -= factor * m[column][pivot];
        }
        b[row] -= factor * b[pivot];
      }
    }
  }
  for (int row = 0; row < 3; ++row)
  {
    b[row] = unknowns >> row & 1 ? b[row] / m[row][row] : 0.0;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
PlanesTest::PlanesTest(std::vector<Plane> planes)
  : Planes(std::move(planes))
{
}

//------------------------------------------------------------------------------
Overlap PlanesTest::Classify(const Box& cell, std::uint64_t& pending) const
{
  bool inside = true;
  for (std::size_t n = 0; n < this->Planes.size(); ++n)
  {
    if (!IsPending(n, pending))
    {
      continue; // an ancestor is on the inner side
    }
    const Plane& plane = this->Planes[n];
    const double tolerance = GetTolerance(plane, cell);
    if (Evaluate(plane, GetCorner(cell, -plane.Normal)) >= tolerance)
    {
      return Overlap::Outside;
    }
    if (Evaluate(plane, GetCorner(cell, plane.Normal)) < -tolerance)
    {
      pending &= ~(n < Noted ? std::uint64_t{ 1 } << n : 0);
    }
    else
    {
      inside = false;
    }
  }
  return inside ? Overlap::Inside : Overlap::Partly;
}

//------------------------------------------------------------------------------
bool PlanesTest::Contains(const glm::dvec3& point, std::uint64_t pending) const
{
  for (std::size_t n = 0; n < this->Planes.size(); ++n)
  {
    if (IsPending(n, pending) && !(Evaluate(this->Planes[n], point) < 0.0))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
SphereTest::SphereTest(const glm::dvec3& center, double radius)
  : Center(center)
  , Square(radius * radius)
{
}

//------------------------------------------------------------------------------
Overlap SphereTest::Classify(const Box& cell, std::uint64_t& /*pending*/) const
{
  if (!this->Contains(glm::clamp(this->Center, cell.Low, cell.High)))
  {
    return Overlap::Outside;
  }
  const glm::dvec3 below = glm::abs(cell.Low - this->Center);
  const glm::dvec3 above = glm::abs(cell.High - this->Center);
  const glm::dvec3 farthest(below.x > above.x ? cell.Low.x : cell.High.x,
    below.y > above.y ? cell.Low.y : cell.High.y, below.z > above.z ? cell.Low.z : cell.High.z);
  return this->Contains(farthest) ? Overlap::Inside : Overlap::Partly;
}

//------------------------------------------------------------------------------
bool SphereTest::Contains(const glm::dvec3& point, std::uint64_t /*pending*/) const
{
  const glm::dvec3 d = point - this->Center;
  return d.x * d.x + d.y * d.y + d.z * d.z - this->Square < 0.0;
}

//------------------------------------------------------------------------------
EllipsoidTest::EllipsoidTest(const glm::dmat3& matrix, const glm::dvec3& shift, double radius)
  : Matrix(matrix)
  , Shift(shift)
  , Square(radius * radius)
{
}

//------------------------------------------------------------------------------
double EllipsoidTest::GetValue(const glm::dvec3& point) const
{
  const glm::dvec3 d = this->Matrix * point + this->Shift;
  return glm::dot(d, d) - this->Square;
}

//------------------------------------------------------------------------------
double EllipsoidTest::GetMinimum(const Box& cell) const
{
  // The minimum of a convex quadratic over a box is that over the plane of one of its 27 faces,
  // edges and corners, the box itself among them, where that minimum is within the box.
  const glm::dmat3 squares = glm::transpose(this->Matrix) * this->Matrix;
  double least = std::numeric_limits<double>::infinity();
  for (int face = 0; face < 27; ++face)
  {
    glm::dvec3 point(0.0);
    unsigned int unknowns = 0;
    for (int axis = 0, digits = face; axis < 3; ++axis, digits /= 3)
    {
      unknowns |= (digits % 3 == 2 ? 1U : 0U) << axis;
      point[axis] = digits % 3 == 2 ? 0.0 : digits % 3 ? cell.High[axis] : cell.Low[axis];
    }
    glm::dvec3 free = -(glm::transpose(this->Matrix) * (this->Matrix * point + this->Shift));
    if (SolveFor(unknowns, squares, free))
    {
      least = std::min(least, this->GetValue(glm::clamp(point + free, cell.Low, cell.High)));
    }
  }
  return least;
}

//------------------------------------------------------------------------------
Overlap EllipsoidTest::Classify(const Box& cell, std::uint64_t& /*pending*/) const
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point(corner & 1 ? cell.High.x : cell.Low.x,
      corner & 2 ? cell.High.y : cell.Low.y, corner & 4 ? cell.High.z : cell.Low.z);
    largest = std::max(largest, this->GetValue(point) + this->Square);
  }
  constexpr double relative = 1e-9; // of solutions where the matrix is nearly singular
  const double tolerance = relative * (largest + this->Square);
  if (largest - this->Square < -tolerance)
  {
    return Overlap::Inside;
  }
  return this->GetMinimum(cell) > tolerance ? Overlap::Outside : Overlap::Partly;
}

//------------------------------------------------------------------------------
bool EllipsoidTest::Contains(const glm::dvec3& point, std::uint64_t /*pending*/) const
{
  return this->GetValue(point) < 0.0;
}

//------------------------------------------------------------------------------
BoxTest::BoxTest(const Box& box)
  : Bounds(box)
{
}

//------------------------------------------------------------------------------
Overlap BoxTest::Classify(const Box& cell, std::uint64_t& /*pending*/) const
{
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = this->Bounds.Low[axis];
    const double high = this->Bounds.High[axis];
    const bool flat = low == high;
    if (flat ? cell.Low[axis] > low || cell.High[axis] <= low
             : cell.Low[axis] >= high || cell.High[axis] <= low)
    {
      return Overlap::Outside;
    }
    inside = inside && !flat && cell.Low[axis] > low && cell.High[axis] <= high;
  }
  return inside ? Overlap::Inside : Overlap::Partly;
}

//------------------------------------------------------------------------------
bool BoxTest::Contains(const glm::dvec3& point, std::uint64_t /*pending*/) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = point[axis];
    const double low = this->Bounds.Low[axis];
    const double high = this->Bounds.High[axis];
    if (low == high ? x != low : !(x > low && x < high))
    {
      return false;
    }
  }
  return true;
}

} // namespace bravais
