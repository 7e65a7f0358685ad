// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SplineRowsTesting_h
#define SplineRowsTesting_h

/// \file
/// What the tests of BCCSplineRows evaluate, and what they compare with.

#include "BCCSplineRows.h"
#include "SplineTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace bravais
{

/// Coefficients for points between low and high: those that are used, and NaN beyond their end.
template <class R>
struct Coefficients
{
  Coefficients(const glm::ivec3& low, const glm::ivec3& high)
  {
    const glm::ivec3 begin = glm::ivec3(low.x >> 1, low.y >> 1, low.z) - BCCReachBelow;
    const glm::ivec3 end = glm::ivec3(high.x >> 1, high.y >> 1, high.z) + BCCReachAbove;
    this->Extent = { begin.x, end.x, begin.y, end.y, begin.z, end.z };
    for (int k = begin.z; k <= end.z; ++k)
    {
      for (int j = begin.y; j <= end.y; ++j)
      {
        for (int i = begin.x; i <= end.x; ++i)
        {
          this->Data.push_back(static_cast<R>(GetCoefficient(BCCLattice::ToPoint({ i, j, k }))));
        }
      }
    }
    this->Data.insert(this->Data.end(), GetBCCResultSize(0), std::numeric_limits<R>::quiet_NaN());
  }

  BCCBlock<const R> GetBlock() const { return { this->Data.data(), this->Extent }; }

  BCCExtent Extent;
  std::vector<R> Data;
};

/// Values, or values and the three components of gradients, of all points.
template <class R>
struct Results
{
  Results(std::size_t size, bool gradients)
    : Size(size)
    , Arrays(gradients ? 4 : 1, std::vector<R>(GetBCCResultSize(size)))
  {
  }

  BCCResults<R> Get()
  {
    return this->Arrays.size() == 1 ? BCCResults<R>{ this->Arrays[0].data() }
                                    : BCCResults<R>{ this->Arrays[0].data(), this->Arrays[1].data(),
                                        this->Arrays[2].data(), this->Arrays[3].data() };
  }

  /// Whether what both have is the same, bit for bit.
  bool operator==(const Results& other) const
  {
    for (std::size_t n = 0; n < std::min(this->Arrays.size(), other.Arrays.size()); ++n)
    {
      if (std::memcmp(this->Arrays[n].data(), other.Arrays[n].data(), this->Size * sizeof(R)) != 0)
      {
        return false;
      }
    }
    return true;
  }

  std::size_t Size;
  std::vector<std::vector<R>> Arrays;
};

template <class R>
BCCPositions<R> MakePositions(const std::vector<glm::dvec3>& points, int axis)
{
  BCCPositions<R> positions(points.size());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    positions.Set(n, BCCPosition<R>(points[n][axis]));
  }
  return positions;
}

template <class R>
Results<R> EvaluatePoints(BCCKernel kernel, const Coefficients<R>& coefficients,
  const std::vector<glm::dvec3>& points, bool gradients = true)
{
  Results<R> results(points.size(), gradients);
  EvaluateBCCPoints<R>(kernel, coefficients.GetBlock(), MakePositions<R>(points, 0),
    MakePositions<R>(points, 1), MakePositions<R>(points, 2), results.Get());
  return results;
}

/// The ways in which rows are evaluated. The dense one has no gradients.
struct RowMode
{
  bool Gradients;
  bool Dense;
};
constexpr RowMode RowModes[] = { { true, false }, { false, false }, { false, true } };

/// Points with the same y and z, ascending in x.
inline std::vector<glm::dvec3> ToRow(std::vector<glm::dvec3> points, const glm::dvec3& first)
{
  for (glm::dvec3& p : points)
  {
    p.y = first.y;
    p.z = first.z;
  }
  std::sort(points.begin(), points.end(),
    [](const glm::dvec3& p, const glm::dvec3& q) { return p.x < q.x; });
  return points;
}

template <class R>
Results<R> EvaluateRow(BCCKernel kernel, const Coefficients<R>& coefficients,
  const std::vector<glm::dvec3>& row, const RowMode& mode)
{
  Results<R> results(row.size(), mode.Gradients);
  const glm::dvec3 first = row.empty() ? glm::dvec3(0.0) : row.front();
  auto x = MakePositions<R>(row, 0);
  x.SetDense(mode.Dense);
  EvaluateBCCRow<R>(kernel, coefficients.GetBlock(), x, BCCPosition<R>(first.y),
    BCCPosition<R>(first.z), results.Get());
  return results;
}

/// Compares with BoxSpline.h in double, of the same coefficients.
template <class R>
void ExpectSplines(
  BCCKernel kernel, const std::vector<glm::dvec3>& points, const Results<R>& results)
{
  const double tolerance = 30.0 * static_cast<double>(std::numeric_limits<R>::epsilon());
  const auto fetch = [](const glm::ivec3& p)
  { return static_cast<double>(static_cast<R>(GetCoefficient(p))); };
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    glm::dvec3 gradient;
    const double value = EvaluateBoxSpline(kernel, fetch, points[n], gradient);
    EXPECT_NEAR(results.Arrays[0][n], value, tolerance) << GetName(kernel);
    for (std::size_t axis = 0; axis + 1 < results.Arrays.size(); ++axis)
    {
      EXPECT_NEAR(results.Arrays[axis + 1][n], gradient[static_cast<int>(axis)], tolerance)
        << GetName(kernel);
    }
  }
}

/// Evaluates a row in all ways.
template <class R>
void ExpectRow(
  BCCKernel kernel, const Coefficients<R>& coefficients, const std::vector<glm::dvec3>& row)
{
  for (const RowMode& mode : RowModes)
  {
    SCOPED_TRACE(mode.Dense ? "dense" : mode.Gradients ? "with gradients" : "without gradients");
    ExpectSplines(kernel, row, EvaluateRow(kernel, coefficients, row, mode));
  }
}

} // namespace bravais

#endif
