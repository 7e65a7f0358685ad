// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCBricks.h"

#include "BCCLattice.h"
#include "BoxSpline.h"
#include "SplineTesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace bravais;

namespace
{

/// The texels of a volume, or of a piece that starts at an odd layer.
struct Volume
{
  Volume(const glm::ivec3& dimensions, int firstLayer, int components)
    : FirstLayer(firstLayer)
    , Last(2 * dimensions.x - 1, 2 * dimensions.y - 1, firstLayer + dimensions.z - 1)
    , Size(dimensions.x + 4, dimensions.y + 4, 2 * (this->Last.z / 2 + 5))
    , Components(components)
    , Values(static_cast<std::size_t>(this->Size.x) * static_cast<std::size_t>(this->Size.y) *
        static_cast<std::size_t>(this->Size.z) * static_cast<std::size_t>(components))
  {
  }

  float* Find(const glm::ivec3& p, int component)
  {
    float* row = const_cast<float*>(this->GetTexels().GetRow(p.y, p.z));
    return row + ((p.x >> 1) + BCCTexels::Halo) * this->Components + component;
  }

  /// Fills texels and halo with random coefficients, continued by the mirrors.
  void Fill()
  {
    for (int Z = -4; Z < this->Size.z - 4; ++Z)
    {
      for (int Y = -4 + (Z & 1); (Y >> 1) < this->Size.y - 2; Y += 2)
      {
        for (int X = -4 + (Z & 1); (X >> 1) < this->Size.x - 2; X += 2)
        {
          for (int c = 0; c < this->Components; ++c)
          {
            *this->Find({ X, Y, Z }, c) = this->Get({ X, Y, Z }, c);
          }
        }
      }
    }
  }

  float Get(const glm::ivec3& p, int component) const
  {
    const int first = this->FirstLayer;
    const glm::ivec3 image(BCCLattice::Mirror(p.x, this->Last.x),
      BCCLattice::Mirror(p.y, this->Last.y),
      first + BCCLattice::Mirror(p.z - first, this->Last.z - first));
    return static_cast<float>(GetCoefficient(image + glm::ivec3(0, 0, 64 * component)));
  }

  BCCTexels GetTexels() const { return { this->Values.data(), this->Size, this->Components }; }

  BCCBricks MakeBricks(BCCKernel kernel) const
  {
    BCCBricks bricks(this->Last, this->FirstLayer, this->Components);
    for (int layer = 0; layer < bricks.GetSize().z; ++layer)
    {
      bricks.ComputeLayer(kernel, this->GetTexels(), layer);
    }
    return bricks;
  }

  int FirstLayer;
  glm::ivec3 Last;
  glm::ivec3 Size;
  int Components;
  std::vector<float> Values;
};

std::size_t FindBrick(const BCCBricks& bricks, const glm::ivec3& b, int component)
{
  const glm::ivec3& size = bricks.GetSize();
  return static_cast<std::size_t>(
    (b.x + size.x * (b.y + size.y * b.z)) * bricks.GetComponents() + component);
}

} // namespace

TEST(TestBCCBricks, ReachIsThatOfTheKernels)
{
  for (const BCCKernel kernel : AllKernels)
  {
    const double reach = BCCBricks::GetReach(kernel);
    double inside = 0.0;
    for (const glm::dvec3& p : MakePoints(20000, 4.5))
    {
      const bool outside = glm::any(glm::greaterThanEqual(glm::abs(p), glm::dvec3(reach)));
      const double value = EvaluateKernel(kernel, p);
      EXPECT_TRUE(!outside || std::abs(value) < 1e-12) << reach;
      inside = std::max(inside, value != 0.0 ? std::abs(p.x) : 0.0);
    }
    EXPECT_GT(inside, reach - 1.0);
  }
}

TEST(TestBCCBricks, BoundsAreThoseOfTheCoefficientsThatReachIn)
{
  for (const BCCKernel kernel : AllKernels)
  {
    const int reach = BCCBricks::GetReach(kernel);
    for (const int first : { 0, 1 })
    {
      Volume volume({ 7, 5, 11 }, first, 2);
      volume.Fill();
      const BCCBricks bricks = volume.MakeBricks(kernel);
      const glm::ivec3 size = bricks.GetSize();
      ASSERT_EQ(size, glm::ivec3(3, 2, first == 0 ? 2 : 3));
      for (int n = 0; n < size.x * size.y * size.z; ++n)
      {
        const glm::ivec3 b(n % size.x, n / size.x % size.y, n / (size.x * size.y));
        const glm::ivec3 low = glm::max(BCCBricks::Edge * b, glm::ivec3(0, 0, first));
        const glm::ivec3 high = glm::min(BCCBricks::Edge * (b + 1), volume.Last);
        for (int c = 0; c < 2; ++c)
        {
          const int nearReach = BCCBricks::GetNearReach(kernel);
          float least[2] = { 2.0f, 2.0f }; // of the near ones, and of all
          float most[2] = { -2.0f, -2.0f };
          for (const glm::ivec3& p : MakeLatticePoints(20))
          {
            if (glm::all(glm::greaterThan(p, low - reach)) &&
              glm::all(glm::lessThan(p, high + reach)))
            {
              const bool near = glm::all(glm::greaterThan(p, low - nearReach)) &&
                glm::all(glm::lessThan(p, high + nearReach));
              for (int bound = near ? 0 : 1; bound < 2; ++bound)
              {
                least[bound] = std::min(least[bound], volume.Get(p, c));
                most[bound] = std::max(most[bound], volume.Get(p, c));
              }
            }
          }
          const float weight = BCCBricks::GetFarWeight(kernel);
          ASSERT_EQ(
            bricks.GetLow()[FindBrick(bricks, b, c)], least[0] + weight * (least[1] - least[0]));
          ASSERT_EQ(
            bricks.GetHigh()[FindBrick(bricks, b, c)], most[0] + weight * (most[1] - most[0]));
        }
      }
    }
  }
}

TEST(TestBCCBricks, FarCoefficientsHaveLittleWeight)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto points = MakeLatticePoints(8);
  for (const BCCKernel kernel : AllKernels)
  {
    const int reach = BCCBricks::GetNearReach(kernel);
    double most = 0.0;
    for (int n = 0; n < 400; ++n)
    {
      // In a brick that starts at (-1, 0, 1), near its faces, some on them and some on its edges.
      const glm::ivec3 low(-1, 0, 1);
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double x = n % 2 ? 0.5 * uniform(random) : 0.0;
        p[axis] = low[axis] + (n / 2 % 4 == axis ? 5.0 * uniform(random) : x);
      }
      double weight = 0.0;
      for (const glm::ivec3& q : points)
      {
        const bool near = glm::all(glm::greaterThan(q, low - reach)) &&
          glm::all(glm::lessThan(q, low + BCCBricks::Edge + reach));
        weight += near ? 0.0 : EvaluateKernel(kernel, p - glm::dvec3(q));
      }
      most = std::max(most, weight);
    }
    EXPECT_LE(most, BCCBricks::GetFarWeight(kernel) + 1e-12);
    EXPECT_GE(most, 0.5 * BCCBricks::GetFarWeight(kernel));
  }
}

TEST(TestBCCBricks, TheSplineStaysInTheBounds)
{
  std::mt19937 random(5);
  for (const BCCKernel kernel : AllKernels)
  {
    Volume volume({ 9, 8, 15 }, 1, 1);
    volume.Fill();
    const BCCBricks bricks = volume.MakeBricks(kernel);
    const auto fetch = [&](const glm::ivec3& p) { return double(volume.Get(p, 0)); };
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int n = 0; n < 20000; ++n)
    {
      const glm::dvec3 low(0.0, 0.0, 1.0);
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = low[axis] + uniform(random) * (volume.Last[axis] - low[axis]);
      }
      glm::dvec3 gradient;
      const double value = EvaluateBoxSpline(kernel, fetch, p, gradient);
      const std::size_t brick =
        FindBrick(bricks, glm::min(glm::ivec3(p) / BCCBricks::Edge, bricks.GetSize() - 1), 0);
      ASSERT_GE(value, bricks.GetLow()[brick] - 1e-9);
      ASSERT_LE(value, bricks.GetHigh()[brick] + 1e-9);
    }
  }
}

TEST(TestBCCBricks, WhatIsNotFiniteHasNoBounds)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : { std::numeric_limits<float>::quiet_NaN(), infinity, -infinity })
  {
    Volume volume({ 12, 12, 24 }, 0, 1);
    volume.Fill();
    *volume.Find({ 10, 10, 10 }, 0) = bad;
    const BCCBricks bricks = volume.MakeBricks(BCCKernel::BCC7);
    int count = 0;
    for (std::size_t n = 0; n < bricks.GetLow().size(); ++n)
    {
      count += bricks.GetLow()[n] == -infinity && bricks.GetHigh()[n] == infinity;
    }
    EXPECT_EQ(count, 8); // (10, 10, 10) is a corner of eight bricks, and further from all others.
  }
}
