// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Rank1Search.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using namespace bravais;
using Vector = Rank1Lattice::Vector;

namespace
{

/// The largest minimum distance of all lattices of n points, by looking at every one: those of
/// Hermite's basis (d, c), (0, n / d) that one vector generates.
double FindByLookingAtAll(std::int64_t n, const glm::dvec2& size, bool korobov = false)
{
  double best = 0.0;
  for (std::int64_t d = 1; d <= (korobov ? 1 : n); ++d)
  {
    for (std::int64_t c = 0; n % d == 0 && c < n / d; ++c)
    {
      for (std::int64_t g2 = c; g2 < n || n == 1; g2 += n / d)
      {
        if (const auto lattice = Rank1Lattice::Create(n, d, g2, size))
        {
          best = std::max(best, lattice->GetMinimumDistance());
          break;
        }
        if (n == 1)
        {
          break;
        }
      }
    }
  }
  return best;
}

/// The same by the definition: all generators, all points.
double FindByDefinition(std::int64_t n, const glm::dvec2& size)
{
  double best = 0.0;
  for (std::int64_t g1 = 0; g1 < n; ++g1)
  {
    for (std::int64_t g2 = 0; g2 < n; ++g2)
    {
      double least = std::min(size.x, size.y);
      for (std::int64_t i = 1; i < n; ++i)
      {
        const glm::dvec2 point(static_cast<double>(i * g1 % n), static_cast<double>(i * g2 % n));
        const double distance =
          MeasureOnTorus(point / static_cast<double>(n), glm::dvec2(0.0), size);
        least = std::min(least, distance);
      }
      best = std::max(best, least);
    }
  }
  return best;
}

double Maximize(std::int64_t n, const glm::dvec2& size = { 1.0, 1.0 })
{
  return MaximizeMinimumDistance(n, size)->GetMinimumDistance();
}

} // namespace

TEST(TestRank1Search, IsTheBestOfTheDefinition)
{
  for (const glm::dvec2 size : { glm::dvec2(1.0, 1.0), glm::dvec2(0.7, 1.9) })
  {
    for (std::int64_t n = 1; n <= 40; ++n)
    {
      EXPECT_NEAR(Maximize(n, size), FindByDefinition(n, size), 1e-12) << n;
    }
  }
}

TEST(TestRank1Search, IsTheBestOfAllLatticesUpTo200)
{
  for (const glm::dvec2 size : { glm::dvec2(1.0, 1.0), glm::dvec2(3.0, 2.0), glm::dvec2(1.0, 6.28),
         glm::dvec2(1e4, 1.0), glm::dvec2(1.0, 1e6) })
  {
    for (std::int64_t n = 1; n <= 200; ++n)
    {
      EXPECT_NEAR(Maximize(n, size) / FindByLookingAtAll(n, size), 1.0, 1e-12) << n;
    }
  }
}

TEST(TestRank1Search, KorobovFormComesFirst)
{
  std::vector<std::int64_t> others;
  for (std::int64_t n = 2; n <= 200; ++n)
  {
    const Rank1Lattice lattice = *MaximizeMinimumDistance(n);
    const double korobov = FindByLookingAtAll(n, { 1.0, 1.0 }, true);
    const bool equal = korobov > lattice.GetMinimumDistance() * (1.0 - 1e-9);
    EXPECT_EQ(lattice.GetGenerator().x == 1, equal) << n;
    if (!equal)
    {
      others.push_back(n);
    }
  }
  ASSERT_GE(others.size(), 4u);
  EXPECT_EQ(std::vector<std::int64_t>(others.begin(), others.begin() + 4),
    (std::vector<std::int64_t>{ 12, 30, 40, 56 }));
  for (int log2 = 1; log2 <= 24; ++log2)
  {
    EXPECT_EQ(MaximizeMinimumDistance(std::int64_t{ 1 } << log2)->GetGenerator().x, 1) << log2;
  }
}

TEST(TestRank1Search, IsTheBestOfTable1AndFigure3)
{
  const std::int64_t rows[][3] = { { 56, 4, 7 }, { 16384, 137, 13 }, { 30976, 188, 17 },
    { 50176, 211, 116 }, { 135424, 13, 395 }, { 147456, 413, 27 }, { 160000, 430, 17 },
    { 262144, 1, 1990 } };
  for (const auto& row : rows)
  {
    EXPECT_EQ(Maximize(row[0]), Rank1Lattice::Create(row[0], row[1], row[2])->GetMinimumDistance())
      << row[0];
  }
  // That of Figure 7 is not.
  EXPECT_GT(Maximize(2048), Rank1Lattice::Create(2048, 31, 39)->GetMinimumDistance());
}

TEST(TestRank1Search, HexagonalFamilyIsThatOfTheorem1)
{
  // Convergents F / M of the square root of 3; n = 2 F M and the generator (M, F).
  std::int64_t before[2] = { 1, 1 };
  std::int64_t now[2] = { 2, 1 };
  for (int m = 1; 2 * now[0] * now[1] < Rank1Lattice::MaximumNumberOfPoints; ++m)
  {
    const std::int64_t n = 2 * now[0] * now[1];
    const Rank1Lattice lattice = *MaximizeMinimumDistance(n);
    const Rank1Lattice expected = *Rank1Lattice::Create(n, now[1], now[0]);
    EXPECT_EQ(lattice.GetMinimumDistance(), expected.GetMinimumDistance()) << n;
    if (n > 1000)
    {
      EXPECT_GT(lattice.GetSamplingEfficiency(), 0.906);
    }
    const std::int64_t factor = m % 2 ? 2 : 1; // 1 + 1 / (1 + 1 / (2 + 1 / (1 + ..
    for (int i : { 0, 1 })
    {
      before[i] += factor * now[i];
      std::swap(before[i], now[i]);
    }
  }
}

TEST(TestRank1Search, NumbersOfAllSizesAreNearlyHexagonal)
{
  for (const std::int64_t n : { std::int64_t{ 1 } << 18, std::int64_t{ 1 } << 22,
         std::int64_t{ 1 } << 24, std::int64_t{ 16777213 }, std::int64_t{ 720720 },
         std::int64_t{ 5000011 }, Rank1Lattice::MaximumNumberOfPoints })
  {
    for (const glm::dvec2 size : { glm::dvec2(1.0, 1.0), glm::dvec2(16.0, 9.0) })
    {
      const double efficiency = MaximizeMinimumDistance(n, size)->GetSamplingEfficiency();
      EXPECT_GT(efficiency, 0.9) << n;
      EXPECT_LT(efficiency, 0.9069) << n;
    }
  }
}

TEST(TestRank1Search, ScaleOfTheAreaDoesNotMatter)
{
  for (const std::int64_t n : { 97, 1000, 30030 })
  {
    const Rank1Lattice unit = *MaximizeMinimumDistance(n, { 1.5, 1.0 });
    const Rank1Lattice scaled = *MaximizeMinimumDistance(n, { 150.0, 100.0 });
    EXPECT_EQ(unit.GetGenerator(), scaled.GetGenerator());
    EXPECT_NEAR(scaled.GetMinimumDistance(), 100.0 * unit.GetMinimumDistance(), 1e-9);
  }
}

TEST(TestRank1Search, LayoutsNumberTheSamePoints)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (const Rank1Layout layout : { Rank1Layout::Korobov, Rank1Layout::Locality })
    {
      const Rank1Lattice other = ChooseGenerator(lattice, layout);
      EXPECT_EQ(other.GetBasis(0), lattice.GetBasis(0));
      EXPECT_EQ(other.GetBasis(1), lattice.GetBasis(1));
      EXPECT_EQ(other.GetSize(), lattice.GetSize());
    }
    const Vector g = ChooseGenerator(lattice, Rank1Layout::Korobov).GetGenerator();
    EXPECT_EQ(g.x,
      std::gcd(lattice.GetGenerator().x, lattice.GetNumberOfPoints()) %
        lattice.GetNumberOfPoints());
  }
}

TEST(TestRank1Search, LocalityPutsANeighborNext)
{
  for (int log2 = 8; log2 <= 24; ++log2)
  {
    const std::int64_t n = std::int64_t{ 1 } << log2;
    const Rank1Lattice lattice = *MaximizeMinimumDistance(n, { 1.0, 1.0 }, Rank1Layout::Locality);
    const auto six = lattice.GetNeighbors(0);
    EXPECT_TRUE(std::count(six.begin(), six.end(), 1)) << log2;
    EXPECT_EQ(lattice.GetMinimumDistance(), Maximize(n));
    if (log2 >= 12)
    {
      EXPECT_NEAR(MeasureLayout(lattice, 16), (1.0 / 16.0 + 2.0) / 3.0, 1e-12);
      EXPECT_LE(MeasureLayout(lattice, 16), MeasureLayout(*MaximizeMinimumDistance(n), 16));
    }
  }
  // Where no neighbour generates the lattice, another vector does.
  for (std::int64_t n = 1; n < 400; ++n)
  {
    EXPECT_EQ(MaximizeMinimumDistance(n, { 1.0, 1.0 }, Rank1Layout::Locality)->GetMinimumDistance(),
      Maximize(n));
  }
}

TEST(TestRank1Search, RefusesWhatHasNoLattice)
{
  EXPECT_FALSE(MaximizeMinimumDistance(0));
  EXPECT_FALSE(MaximizeMinimumDistance(-3));
  EXPECT_FALSE(MaximizeMinimumDistance(Rank1Lattice::MaximumNumberOfPoints + 1));
  EXPECT_FALSE(MaximizeMinimumDistance(8, { 1.0, -1.0 }));
  EXPECT_FALSE(MaximizeMinimumDistance(8, { std::numeric_limits<double>::quiet_NaN(), 1.0 }));
}
