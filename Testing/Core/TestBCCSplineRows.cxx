// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SplineRowsTesting.h"

#include <hwy/targets.h>

using namespace bravais;

namespace
{

std::vector<glm::dvec3> MakeLatticePositions(int reach)
{
  std::vector<glm::dvec3> points;
  for (const glm::ivec3& p : MakeLatticePoints(reach))
  {
    points.emplace_back(p);
  }
  return points;
}

} // namespace

template <class R>
class TestBCCSplineRows : public testing::Test
{
};

using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(TestBCCSplineRows, Reals, );

TYPED_TEST(TestBCCSplineRows, PointsAreThoseOfTheSpline)
{
  const Coefficients<TypeParam> coefficients(glm::ivec3(-8), glm::ivec3(8));
  for (const BCCKernel kernel : AllKernels)
  {
    const auto points = MakePoints(1000, 8.0);
    ExpectSplines(kernel, points, EvaluatePoints(kernel, coefficients, points));
  }
}

TYPED_TEST(TestBCCSplineRows, RowsAreThoseOfTheSpline)
{
  const Coefficients<TypeParam> coefficients(glm::ivec3(-8), glm::ivec3(8));
  const auto random = MakePoints(50, 8.0);
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& first : random)
    {
      const auto points = ToRow(random, first);
      ExpectRow(kernel, coefficients, points);
    }
  }
}

TYPED_TEST(TestBCCSplineRows, LatticePointsAndTheFacesOfTheBoxAreRight)
{
  // Where polynomials meet bcc4 has several gradients: any is right, so values alone are compared.
  const Coefficients<TypeParam> coefficients(glm::ivec3(-6), glm::ivec3(6));
  auto points = MakeLatticePositions(6);
  const auto knots = MakeKnotPoints(500, 6.0);
  points.insert(points.end(), knots.begin(), knots.end());
  for (const BCCKernel kernel : AllKernels)
  {
    const bool gradients = kernel != BCCKernel::BCC4;
    ExpectSplines(kernel, points, EvaluatePoints(kernel, coefficients, points, gradients));
    for (std::size_t n = 0; n < points.size(); n += 37)
    {
      const auto row = ToRow(points, points[n]);
      for (const RowMode& mode : RowModes)
      {
        if (gradients || !mode.Gradients)
        {
          ExpectSplines(kernel, row, EvaluateRow(kernel, coefficients, row, mode));
        }
      }
    }
  }
}

TYPED_TEST(TestBCCSplineRows, ValuesAreTheSameWithoutGradients)
{
  const Coefficients<TypeParam> coefficients(glm::ivec3(-8), glm::ivec3(8));
  const auto points = MakePoints(50, 8.0);
  const auto row = ToRow(points, points[0]);
  for (const BCCKernel kernel : AllKernels)
  {
    EXPECT_TRUE(EvaluatePoints(kernel, coefficients, points, false) ==
      EvaluatePoints(kernel, coefficients, points, true))
      << GetName(kernel);
    EXPECT_TRUE(EvaluateRow(kernel, coefficients, row, RowModes[0]) ==
      EvaluateRow(kernel, coefficients, row, RowModes[1]))
      << GetName(kernel);
  }
}

TYPED_TEST(TestBCCSplineRows, AnyNumberOfPointsIsEvaluated)
{
  const Coefficients<TypeParam> coefficients(glm::ivec3(-8), glm::ivec3(8));
  for (const BCCKernel kernel : AllKernels)
  {
    for (const int size : { 0, 1, 3, 7, 8, 9, 15, 16, 17 })
    {
      const auto points = MakePoints(size, 8.0);
      ExpectSplines(kernel, points, EvaluatePoints(kernel, coefficients, points));
      const auto row = size == 0 ? points : ToRow(points, points[0]);
      ExpectRow(kernel, coefficients, row);
    }
  }
}

TYPED_TEST(TestBCCSplineRows, ResultsDoNotDependOnTheOtherPoints)
{
  using R = TypeParam;
  const Coefficients<R> coefficients(glm::ivec3(-8), glm::ivec3(8));
  const auto points = MakePoints(40, 8.0);
  const auto row = ToRow(points, points[0]);
  const auto isPart = [](const Results<R>& part, const Results<R>& whole, std::size_t begin)
  {
    bool same = true;
    for (std::size_t n = 0; n < part.Arrays.size(); ++n)
    {
      same = same &&
        std::memcmp(part.Arrays[n].data(), whole.Arrays[n].data() + begin, part.Size * sizeof(R)) ==
          0;
    }
    return same;
  };
  for (const BCCKernel kernel : AllKernels)
  {
    const auto allPoints = EvaluatePoints(kernel, coefficients, points);
    for (std::size_t begin = 0; begin < 20; ++begin)
    {
      for (const std::size_t size : { 1, 5, 20 })
      {
        const auto cut = [&](const std::vector<glm::dvec3>& from)
        {
          const auto first = from.begin() + static_cast<std::ptrdiff_t>(begin);
          return std::vector<glm::dvec3>(first, first + static_cast<std::ptrdiff_t>(size));
        };
        EXPECT_TRUE(isPart(EvaluatePoints(kernel, coefficients, cut(points)), allPoints, begin));
        for (const RowMode& mode : RowModes)
        {
          EXPECT_TRUE(isPart(EvaluateRow(kernel, coefficients, cut(row), mode),
            EvaluateRow(kernel, coefficients, row, mode), begin))
            << GetName(kernel);
        }
      }
    }
  }
}

TYPED_TEST(TestBCCSplineRows, ResultsDoNotDependOnTheBlock)
{
  // The smallest blocks are narrower than a vector.
  using R = TypeParam;
  const Coefficients<R> large(glm::ivec3(-20), glm::ivec3(20));
  for (const int begin : { -8, -1, 0, 5 })
  {
    for (const int width : { 1, 2, 6, 10 })
    {
      const Coefficients<R> small(glm::ivec3(begin), glm::ivec3(begin + width));
      auto points = MakePoints(30, 0.5 * width);
      for (glm::dvec3& p : points)
      {
        p += begin + 0.5 * width;
      }
      const auto row = ToRow(points, points[0]);
      for (const BCCKernel kernel : AllKernels)
      {
        EXPECT_TRUE(EvaluatePoints(kernel, small, points) == EvaluatePoints(kernel, large, points))
          << GetName(kernel);
        for (const RowMode& mode : RowModes)
        {
          EXPECT_TRUE(
            EvaluateRow(kernel, small, row, mode) == EvaluateRow(kernel, large, row, mode))
            << GetName(kernel);
        }
      }
    }
  }
}

TYPED_TEST(TestBCCSplineRows, FarPointsAreAsAccurateAsNearOnes)
{
  // So far that floats do not tell neighbouring lattice points apart, and that a place counted
  // from index 0 would not fit 32 bits. The offset keeps all parities.
  using R = TypeParam;
  for (const int sign : { -1, 1 })
  {
    const glm::ivec3 center = sign * glm::ivec3((1 << 28) + 1, 1 << 28, (1 << 29) + 1);
    const Coefficients<R> coefficients(center - 4, center + 4);
    auto points = MakePoints(100, 3.5);
    for (glm::dvec3& p : points)
    {
      p = glm::round(1024.0 * p) / 1024.0 + glm::dvec3(center); // without rounding
    }
    const auto row = ToRow(points, points[0]);
    for (const BCCKernel kernel : AllKernels)
    {
      ExpectSplines(kernel, points, EvaluatePoints(kernel, coefficients, points));
      ExpectRow(kernel, coefficients, row);
    }
  }
}

TYPED_TEST(TestBCCSplineRows, EveryInstructionSetGivesTheSame)
{
  const Coefficients<TypeParam> coefficients(glm::ivec3(-8), glm::ivec3(8));
  const auto points = MakePoints(100, 8.0);
  const auto row = ToRow(points, points[0]);
  const auto targets = hwy::SupportedAndGeneratedTargets();
  EXPECT_FALSE(targets.empty());
  for (const std::int64_t target : targets)
  {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    for (const BCCKernel kernel : AllKernels)
    {
      ExpectSplines(kernel, points, EvaluatePoints(kernel, coefficients, points));
      ExpectRow(kernel, coefficients, row);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TYPED_TEST(TestBCCSplineRows, PositionsAreSplitWithoutLoss)
{
  using R = TypeParam;
  const auto join = [](const BCCPosition<R>& p)
  { return static_cast<double>(p.Even) + static_cast<double>(p.Sign) * p.Offset; };
  for (const double x :
    { 0.0, -0.0, 0.25, 1.0, 1.5, 2.0, -0.25, -1.0, -1.75, -2.0, 1e9 + 0.5, -1e9 - 0.75 })
  {
    const BCCPosition<R> position(x);
    EXPECT_EQ(join(position), x);
    EXPECT_EQ(position.Even % 2, 0);
    EXPECT_TRUE(position.Offset >= 0 && position.Offset <= 1) << x;
  }
}

TYPED_TEST(TestBCCSplineRows, PositionsFillWholeVectors)
{
  using R = TypeParam;
  BCCPositions<R> none(0);
  EXPECT_EQ(none.GetSize(), 0u);
  EXPECT_EQ(none.Sign.size(), GetBCCResultSize(0));
  BCCPositions<R> two(2);
  two.Set(0, BCCPosition<R>(2.5));
  two.Set(1, BCCPosition<R>(-6.75));
  EXPECT_EQ(two.Even[0], 2);
  for (std::size_t n = 1; n < GetBCCResultSize(2); ++n)
  {
    EXPECT_EQ(two.Even[n], -6);
    EXPECT_EQ(two.Sign[n], R(-1));
    EXPECT_EQ(two.Offset[n], R(0.75));
  }
}
