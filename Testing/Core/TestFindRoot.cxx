// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FindRoot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
template <class Function>
double Find(const Function& function)
{
  return bravais::FindRoot(function, function(0.0), function(1.0));
}
}

TEST(TestFindRoot, LinearFunctionsTakeOneEvaluation)
{
  int evaluations = 0;
  const auto line = [&](double s)
  {
    ++evaluations;
    return 3.0 * s - 1.0;
  };
  EXPECT_NEAR(bravais::FindRoot(line, -1.0, 2.0), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(evaluations, 1);
}

TEST(TestFindRoot, RisingAndFallingFunctions)
{
  for (double root : { 0.001, 0.3, 0.5, 0.97 })
  {
    const auto cubic = [root](double s) { return s * s * s - root * root * root; };
    EXPECT_LT(std::abs(cubic(Find(cubic))), 1e-6) << root;
    const auto falling = [root](double s) { return std::exp(-4 * s) - std::exp(-4 * root); };
    EXPECT_NEAR(Find(falling), root, 2e-5) << root;
  }
}

TEST(TestFindRoot, SteepFunctionsConverge)
{
  // Plain regula falsi keeps the far end and creeps.
  const auto steep = [](double s) { return std::pow(s, 9) - 0.01; };
  EXPECT_NEAR(Find(steep), std::pow(0.01, 1.0 / 9.0), 1e-5);
}

TEST(TestFindRoot, ItEndsWithoutARootOrANumber)
{
  const auto jump = [](double s) { return s < 0.4 ? -1.0 : 1.0; };
  EXPECT_NEAR(Find(jump), 0.4, 1e-3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int evaluations = 0;
  bravais::FindRoot(
    [&](double)
    {
      ++evaluations;
      return nan;
    },
    -1.0, 1.0);
  EXPECT_LE(evaluations, 16);
}
