// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCResponse.h"

#include "BCCPrefilterTables.h"
#include "ReferenceBCCSpectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bravais;

TEST(TestBCCResponse, AutocorrelationIsTheSumOverTheDualLattice)
{
  for (const BCCKernel kernel : ReferenceKernels)
  {
    for (const glm::dvec3& w : { glm::dvec3(0.0), glm::dvec3(0.3, -0.5, 1.1),
           glm::dvec3(3.0, 0.05, -0.02), glm::dvec3(1.2, 1.5, 1.5), glm::dvec3(0.0, 0.0, 1.57) })
    {
      double sum = 0.0;
      const int n = 24;
      for (int p = -n; p <= n; ++p)
      {
        for (int q = -n; q <= n; ++q)
        {
          for (int r = -n - ((p + q + n) & 1); r <= n; r += 2)
          {
            const double m = ReferenceTransform(kernel, w + ReferencePi * glm::dvec3(p, q, r));
            sum += m * m;
          }
        }
      }
      EXPECT_NEAR(ReferenceSymbol(GetReferenceTable(kernel, BCCPrefilter::Projection), w), sum,
        kernel == BCCKernel::BCC4 ? 2e-3 : 1e-7)
        << GetName(kernel);
    }
  }
}

TEST(TestBCCResponse, InterpolationOfBCC8IsNeverSingular)
{
  const auto table = GetReferenceTable(BCCKernel::BCC8, BCCPrefilter::Interpolation);
  double least = 1.0;
  for (int n = 0; n < 17 * 17 * 17; ++n)
  {
    const glm::dvec3 w = ReferencePi / 8.0 * glm::dvec3(n % 17, n / 17 % 17, n / 289);
    least = std::min(least, ReferenceSymbol(table, w));
  }
  EXPECT_NEAR(least, 0.2, 1e-15);
}

TEST(TestBCCResponse, FollowsTheDefinition)
{
  const std::array<std::int64_t, 3> last = { 7, 5, 6 };
  for (const BCCKernel kernel : ReferenceKernels)
  {
    for (const BCCPrefilter prefilter : { BCCPrefilter::Interpolation, BCCPrefilter::Projection })
    {
      if (!IsDefined(kernel, prefilter))
      {
        continue;
      }
      const BCCResponse response(kernel, prefilter, last);
      std::vector<BCCResponse::Value> column(4);
      for (int mx = 0; mx < 4; ++mx)
      {
        for (int my = 0; my < 3; ++my)
        {
          response.GetColumn(mx, my, column.data());
          for (int mz = 0; mz < 4; ++mz)
          {
            const glm::dvec3 w = ReferencePi * glm::dvec3(mx / 7.0, my / 5.0, mz / 6.0);
            const double q = ReferenceResponse(kernel, prefilter, w);
            const double shifted =
              ReferenceResponse(kernel, prefilter, w + glm::dvec3(ReferencePi, 0.0, 0.0));
            // Where the gain is high, Projection divides by a small difference of large numbers.
            const double tolerance = 1e-12 + 1e-15 * std::pow(std::abs(shifted), 3);
            ASSERT_NEAR(column[mz].Same + column[mz].Other, q, tolerance);
            ASSERT_NEAR(column[mz].Same - column[mz].Other, shifted, tolerance)
              << GetName(kernel) << ' ' << mx << ' ' << my << ' ' << mz;
          }
        }
      }
    }
  }
}

TEST(TestBCCResponse, LeavesOutSingularFrequencies)
{
  for (const BCCKernel kernel : { BCCKernel::BCC7, BCCKernel::BCC12 })
  {
    // So long that the frequencies next to the singular one count as singular for BCC12.
    const BCCResponse response(kernel, BCCPrefilter::Projection, { 401, 401, 400 });
    std::vector<BCCResponse::Value> column(201);
    response.GetColumn(0, 0, column.data());
    EXPECT_NEAR(column[0].Same + column[0].Other, 1.0, 1e-14);
    EXPECT_EQ(column[0].Same - column[0].Other, 0.0);
    EXPECT_EQ(column[1].Same - column[1].Other == 0.0, kernel == BCCKernel::BCC12);
    for (const BCCResponse::Value& value : column)
    {
      EXPECT_LE(std::abs(value.Same - value.Other), 1.0 / std::sqrt(BCCResponse::SingularValue));
    }
  }
}
