// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCFit.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bravais;

namespace
{
const glm::dvec3 Boxes[] = { { 1, 1, 1 }, { 255 * 0.957, 255 * 0.957, 107 * 1.5 }, { 3, 100, 7 },
  { 1e-9, 2e-9, 3e-9 }, { 50, 0.5, 50 } };
}

TEST(TestBCCFit, FillsTheBoxToTheLastStep)
{
  for (const glm::dvec3& edges : Boxes)
  {
    for (const double count : { 300.0, 5000.0, 118638.0, 7077888.0, 1e12 })
    {
      const auto fit = FitBCC(edges, count);
      ASSERT_TRUE(fit);
      const glm::dvec3 rest = edges / fit->Unit - GetBCCEdges(fit->Dimensions);
      EXPECT_GT(std::min({ rest.x, rest.y, rest.z }), -1e-6);
      EXPECT_LT(std::min({ rest.x, rest.y, rest.z }), 1e-6);
      EXPECT_LT(rest.x, 2.0);
      EXPECT_LT(rest.y, 2.0);
      EXPECT_LT(rest.z, 1.0);
    }
  }
}

TEST(TestBCCFit, ComesAsNearToTheCountAsAnyUnitDoes)
{
  for (const glm::dvec3& edges : Boxes)
  {
    const double volume = edges.x * edges.y * edges.z;
    for (const double count : { 300.0, 5000.0, 118638.0 })
    {
      const auto fit = FitBCC(edges, count);
      ASSERT_TRUE(fit);
      const glm::dvec3 n(fit->Dimensions);
      const double off = std::abs(n.x * n.y * n.z - count);
      // All units round the one of an endless lattice, in small steps.
      const double middle = std::cbrt(volume / (4.0 * count));
      for (double unit = 0.3 * middle; unit < 3.0 * middle; unit *= 1.0001)
      {
        const glm::dvec3 room = edges / unit;
        const double points = std::floor(0.5 * room.x + 0.5) * std::floor(0.5 * room.y + 0.5) *
          (std::floor(room.z) + 1.0);
        const bool usable = points > 0.0 && room.z >= 1.0;
        ASSERT_TRUE(!usable || off <= std::abs(points - count));
      }
    }
  }
}

TEST(TestBCCFit, GivesBackALatticeThatFitsExactly)
{
  const glm::ivec3 dimensions(39, 39, 78);
  const glm::dvec3 edges = 0.1 * GetBCCEdges(dimensions);
  EXPECT_NEAR(FitBCCUnit(edges, dimensions), 0.1, 1e-15);
  const auto fit = FitBCC(edges, 39.0 * 39 * 78);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->Dimensions, dimensions);
  EXPECT_NEAR(fit->Unit, 0.1, 1e-15);
}

TEST(TestBCCFit, RefusesWhatHasNoLattice)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 box(1.0);
  for (const double count : { 0.0, -1.0, nan, infinity, 1e60 })
  {
    EXPECT_FALSE(FitBCC(box, count));
  }
  for (const double edge : { 0.0, -1.0, nan, infinity })
  {
    EXPECT_FALSE(FitBCC({ 1.0, edge, 1.0 }, 100.0));
  }
  const auto least = FitBCC(box, 1e-3);
  ASSERT_TRUE(least);
  EXPECT_EQ(least->Dimensions, glm::ivec3(1, 1, 2));
}
