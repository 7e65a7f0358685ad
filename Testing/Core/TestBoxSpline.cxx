// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoxSpline.h"
#include "ReferenceBoxSpline.h"
#include "SplineTesting.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace bravais;

namespace
{

struct LessPoint
{
  bool operator()(const glm::ivec3& a, const glm::ivec3& b) const
  {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};
using PointSet = std::set<glm::ivec3, LessPoint>;

/// The lattice points whose coefficients are fetched for p, in order.
std::vector<glm::ivec3> GetFetched(BCCKernel kernel, const glm::dvec3& p)
{
  std::vector<glm::ivec3> fetched;
  const auto fetch = [&](const glm::ivec3& j)
  {
    fetched.push_back(j);
    return 0.0;
  };
  glm::dvec3 gradient;
  EvaluateBoxSpline(kernel, fetch, p, gradient);
  return fetched;
}

/// The lattice points whose kernels are positive at p.
PointSet GetReaching(BCCKernel kernel, const glm::dvec3& p)
{
  PointSet reaching;
  for (const glm::ivec3& j : MakeLatticePoints(8))
  {
    if (EvaluateKernel(kernel, p - glm::dvec3(j)) > 0.0)
    {
      reaching.insert(j);
    }
  }
  return reaching;
}

/// Random points, and points where polynomials meet.
std::vector<glm::dvec3> MakeAllPoints(int count, double reach)
{
  auto points = MakePoints(count, reach);
  const auto knots = MakeKnotPoints(count, reach);
  points.insert(points.end(), knots.begin(), knots.end());
  return points;
}

template <std::size_t N>
PointSet ToSet(const int (&stencil)[N][3])
{
  PointSet points;
  for (const int(&p)[3] : stencil)
  {
    points.insert({ p[0], p[1], p[2] });
  }
  return points;
}

} // namespace

TEST(TestBoxSpline, AgreesWithTheRecurrence)
{
  for (const BCCKernel kernel : AllKernels)
  {
    ReferenceBoxSpline reference(kernel);
    for (const glm::dvec3& random : MakePoints(60, 3.0))
    {
      const glm::dvec3 p = ReferenceBoxSpline::Round(random);
      EXPECT_NEAR(EvaluateKernel(kernel, p), reference(p), 1e-15) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, AgreesWithTheRecurrenceOnKnotPlanes)
{
  for (const BCCKernel kernel : AllKernels)
  {
    ReferenceBoxSpline reference(kernel);
    for (const glm::dvec3& p : MakeKnotPoints(60, 2.5))
    {
      EXPECT_NEAR(EvaluateKernel(kernel, p), reference(p), 1e-15) << GetName(kernel);
    }
    EXPECT_NEAR(EvaluateKernel(kernel, { 0, 0, 0 }), reference({ 0, 0, 0 }), 1e-15);
  }
}

TEST(TestBoxSpline, KernelsSumToOne)
{
  const auto lattice = MakeLatticePoints(7);
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakeAllPoints(100, 2.5))
    {
      double sum = 0.0;
      for (const glm::ivec3& j : lattice)
      {
        sum += EvaluateKernel(kernel, p - glm::dvec3(j));
      }
      EXPECT_NEAR(sum, 1.0, 2e-15) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, KernelsAreNotNegative)
{
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakeAllPoints(20000, 4.0))
    {
      EXPECT_GE(EvaluateKernel(kernel, p), -1e-16) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, KernelsVanishBeyondTheirSupport)
{
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : { glm::dvec3(4, 0, 0), glm::dvec3(0, -4, 0), glm::dvec3(1, 2, 1e9),
           glm::dvec3(-1e300, 0, 0), glm::dvec3(3.999, 3.999, -3.999) })
    {
      EXPECT_NEAR(EvaluateKernel(kernel, p), 0.0, 1e-20) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, StencilsHaveTheirNumberOfPoints)
{
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakePoints(50, 3.0))
    {
      EXPECT_EQ(GetReaching(kernel, p).size(), GetStencilSize(kernel)) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, FetchesThePointsThatReachAndNoOther)
{
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakePoints(50, 3.0))
    {
      const auto fetched = GetFetched(kernel, p);
      EXPECT_EQ(fetched.size(), GetStencilSize(kernel)) << GetName(kernel);
      EXPECT_EQ(PointSet(fetched.begin(), fetched.end()), GetReaching(kernel, p))
        << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, StencilTablesAreThoseOfTheReferenceTetrahedron)
{
  const glm::dvec3 p(0.83, 0.47, 0.21);
  EXPECT_EQ(ToSet(BCC4Stencil), GetReaching(BCCKernel::BCC4, p));
  EXPECT_EQ(ToSet(BCC7Stencil), GetReaching(BCCKernel::BCC7, p));
  EXPECT_EQ(ToSet(BCC8Stencil), GetReaching(BCCKernel::BCC8, p));
}

TEST(TestBoxSpline, KernelsHaveTheSymmetriesOfTheCube)
{
  const auto symmetries = MakeCubeSymmetries();
  ASSERT_EQ(symmetries.size(), 48u);
  for (const BCCKernel kernel : AllKernels)
  {
    for (const glm::dvec3& p : MakeAllPoints(100, 4.0))
    {
      const double value = EvaluateKernel(kernel, p);
      for (const CubeSymmetry& symmetry : symmetries)
      {
        EXPECT_NEAR(EvaluateKernel(kernel, symmetry(p)), value, 2e-16) << GetName(kernel);
      }
    }
  }
}

TEST(TestBoxSpline, SplinesTurnWithTheirCoefficients)
{
  // A symmetry and a translation of the lattice carry each tetrahedron to each other one.
  const glm::ivec3 translation(3, -5, 1);
  const glm::dvec3 p(0.83, 0.47, 0.21);
  for (const BCCKernel kernel : AllKernels)
  {
    glm::dvec3 gradient;
    const double value = EvaluateBoxSpline(kernel, GetCoefficient, p, gradient);
    for (const CubeSymmetry& symmetry : MakeCubeSymmetries())
    {
      const auto fetch = [&](const glm::ivec3& j)
      { return GetCoefficient(symmetry.Undo(j - translation)); };
      glm::dvec3 turned;
      EXPECT_NEAR(EvaluateBoxSpline(kernel, fetch, symmetry(p) + glm::dvec3(translation), turned),
        value, 2e-15)
        << GetName(kernel);
      EXPECT_LT(glm::length(symmetry.Undo(turned) - gradient), 1e-14) << GetName(kernel);
    }
  }
}

TEST(TestBoxSpline, FramesCarryPointsToTheReferenceTetrahedron)
{
  for (const glm::dvec3& p : MakeAllPoints(2000, 9.0))
  {
    const BCCFrame<double> frame = FindBCCFrame(p);
    const glm::dvec3& x = frame.Point;
    EXPECT_TRUE(1.0 >= x.x && x.x >= x.y && x.y >= x.z && x.z >= 0.0);
    EXPECT_EQ(frame.Even & glm::ivec3(1), glm::ivec3(0));
    const glm::ivec3 diagonal = frame.Steps[0] + frame.Steps[1] + frame.Steps[2];
    EXPECT_EQ(glm::abs(diagonal), glm::ivec3(2));
    EXPECT_EQ(2 * (frame.Odd - frame.Even), diagonal);
    const glm::dvec3 back = frame.TurnBack(x) + glm::dvec3(frame.Even);
    EXPECT_LT(glm::length(back - p), 1e-14);
  }
}

TEST(TestBoxSpline, SplinesOfTheSameCoefficientsAreDifferent)
{
  std::set<double> values;
  glm::dvec3 gradient;
  for (const BCCKernel kernel : AllKernels)
  {
    values.insert(EvaluateBoxSpline(kernel, GetCoefficient, glm::dvec3(0.3, 0.2, 0.9), gradient));
  }
  EXPECT_EQ(values.size(), 4u);
}
