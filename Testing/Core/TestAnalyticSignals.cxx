// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "AnalyticSignals.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bravais;

TEST(TestAnalyticSignals, MarschnerLobbOnItsAxes)
{
  // On the z axis rho is cos(2 pi f) = 1 for whole f, at distance 1 it is 1 too.
  for (const double z : { -1.0, -0.5, 0.0, 0.25, 1.0 })
  {
    const double expected = (1.5 - std::sin(std::acos(-1.0) * z / 2)) / 2.5;
    EXPECT_NEAR(MarschnerLobb({ 0, 0, z }, 0.25, 6), expected, 1e-14);
    EXPECT_NEAR(MarschnerLobb({ 0.6, -0.8, z }, 0.25, 6), expected, 1e-14);
  }
  // Without ripples a slope along z is left.
  EXPECT_NEAR(MarschnerLobb({ 0.3, 0.1, 0.0 }, 0.0, 6), 0.5, 1e-15);
}

TEST(TestAnalyticSignals, MarschnerLobbStaysBetweenZeroAndOne)
{
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec3 x(n % 10 / 4.5 - 1, n / 10 % 10 / 4.5 - 1, n / 100 / 4.5 - 1);
    const double value = MarschnerLobb(x, 0.25, 6);
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
    EXPECT_NEAR(value, MarschnerLobb({ -x.y, x.x, x.z }, 0.25, 6), 1e-14);
  }
}

TEST(TestAnalyticSignals, GaussianFallsByItsDeviation)
{
  EXPECT_EQ(Gaussian({ 0, 0, 0 }, 0.3), 1.0);
  EXPECT_NEAR(Gaussian({ 0.3, 0, 0 }, 0.3), std::exp(-0.5), 1e-15);
  EXPECT_NEAR(Gaussian({ 1, -2, 2 }, 1.5), std::exp(-2.0), 1e-15);
}
