// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Rank1Lattice.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

using namespace bravais;
using Vector = Rank1Lattice::Vector;

namespace
{

/// Shortest distance from point 0 to another one or to a copy of itself.
double FindMinimumDistance(const Rank1Lattice& lattice)
{
  const glm::dvec2 size = lattice.GetSize();
  double least = std::min(size.x, size.y);
  for (std::int64_t i = 1; i < lattice.GetNumberOfPoints(); ++i)
  {
    least = std::min(least, MeasureOnTorus(lattice.GetPoint(i), glm::dvec2(0.0), size));
  }
  return least;
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

} // namespace

TEST(TestRank1Lattice, BasisIsReducedAndOfTheLattice)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const std::int64_t n = lattice.GetNumberOfPoints();
    EXPECT_EQ(std::abs(lattice.GetDeterminant()), n);
    for (int which : { 0, 1 })
    {
      const Vector b = lattice.GetBasis(which);
      const Vector point = lattice.GetGridPoint(lattice.GetBasisIndex(which));
      EXPECT_EQ(Vector(Modulo(b.x, n), Modulo(b.y, n)), point);
    }
    const glm::dvec2 a = lattice.ToArea(lattice.GetBasis(0));
    const glm::dvec2 b = lattice.ToArea(lattice.GetBasis(1));
    EXPECT_LE(glm::dot(a, a), glm::dot(b, b));
    EXPECT_GE(glm::dot(a, b), 0.0);
    EXPECT_LE(2.0 * glm::dot(a, b), glm::dot(a, a) * (1.0 + 1e-12));
  }
}

TEST(TestRank1Lattice, MinimumDistanceIsThatOfAllPoints)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    EXPECT_NEAR(lattice.GetMinimumDistance() / FindMinimumDistance(lattice), 1.0, 1e-12)
      << lattice.GetNumberOfPoints() << " " << lattice.GetGenerator().y;
  }
}

TEST(TestRank1Lattice, IndexIsThatOfTheorem2)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const std::int64_t n = lattice.GetNumberOfPoints();
    for (std::int64_t s = -9; s <= 9; ++s)
    {
      for (std::int64_t t = -9; t <= 9; ++t)
      {
        const Vector x = s * lattice.GetBasis(0) + t * lattice.GetBasis(1);
        const std::int64_t i = lattice.GetIndex(s, t);
        ASSERT_EQ(lattice.GetGridPoint(i), Vector(Modulo(x.x, n), Modulo(x.y, n)));
        ASSERT_EQ(lattice.GetIndex(s + n * 1000000007, t - n * 998244353), i);
      }
    }
  }
}

TEST(TestRank1Lattice, ExampleOfFigure5)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(56, 4, 7);
  EXPECT_EQ(lattice.GetBasis(0), Vector(8, 0));
  EXPECT_EQ(lattice.GetBasis(1), Vector(4, 7));
  EXPECT_EQ(lattice.GetBasisIndex(0), 16);
  EXPECT_EQ(lattice.GetBasisIndex(1), 1);
  EXPECT_EQ(lattice.GetIndex(-1, 3), 43);
  EXPECT_EQ(lattice.GetIndex(4, 5), 13);
  const auto neighbors = lattice.GetNeighbors(35);
  EXPECT_EQ(std::set<std::int64_t>(neighbors.begin(), neighbors.end()),
    (std::set<std::int64_t>{ 36, 51, 50, 34, 19, 20 }));
}

TEST(TestRank1Lattice, EfficienciesOfFigure3)
{
  const std::int64_t generators[][2] = { { 3, 11 }, { 1, 9 }, { 1, 21 }, { 4, 7 } };
  const double expected[] = { 44.9, 56.1, 81.3, 89.8 };
  for (int i = 0; i < 4; ++i)
  {
    const auto lattice = Rank1Lattice::Create(56, generators[i][0], generators[i][1]);
    EXPECT_NEAR(100.0 * lattice->GetSamplingEfficiency(), expected[i], 0.05);
  }
}

TEST(TestRank1Lattice, GeneratorsOfTable1)
{
  struct Row
  {
    std::int64_t Numbers[5]; // n, g1, g2, and the printed indices of two basis vectors
    double Efficiency;
  };
  const Row rows[] = { { { 16384, 137, 13, 2511, 2512 }, 90.4 },
    { { 30976, 188, 17, 1, 1813 }, 90.3 }, { { 50176, 211, 116, 4756, 4757 }, 90.2 },
    { { 135424, 13, 395, 52112, 52113 }, 90.6 }, { { 147456, 413, 27, 54627, 54626 }, 90.4 },
    { { 160000, 430, 17, 65860, 65861 }, 90.5 }, { { 262144, 1, 1990, 527, 395 }, 90.3 } };
  for (const Row& row : rows)
  {
    const std::int64_t* p = row.Numbers;
    const auto lattice = Rank1Lattice::Create(p[0], p[1], p[2]);
    ASSERT_TRUE(lattice);
    EXPECT_NEAR(100.0 * lattice->GetSamplingEfficiency(), row.Efficiency, 0.1) << p[0];
    // The printed indices are neighbours; for three rows the first and the third nearest.
    const auto six = lattice->GetNeighbors(0);
    const std::set<std::int64_t> around(six.begin(), six.end());
    EXPECT_TRUE(around.count(p[3]) && around.count(p[4])) << p[0];
  }
}

TEST(TestRank1Lattice, NeighborsAreTheNearest)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    if (lattice.GetNumberOfPoints() < 20 || lattice.GetSamplingEfficiency() < 0.6)
    {
      continue; // the same point may be a neighbour twice, or 2 b1 be nearer than b2
    }
    // No other point is nearer than the second pair.
    const auto ids = lattice.GetNeighbors(5);
    const glm::dvec2 center = lattice.GetPoint(5);
    const std::set<std::int64_t> around(ids.begin(), ids.end());
    std::vector<double> lengths;
    for (const std::int64_t id : ids)
    {
      lengths.push_back(MeasureOnTorus(lattice.GetPoint(id), center, lattice.GetSize()));
    }
    std::sort(lengths.begin(), lengths.end());
    const double second = lengths[3];
    for (std::int64_t i = 0; i < lattice.GetNumberOfPoints(); ++i)
    {
      if (i != 5 && !around.count(i))
      {
        EXPECT_GE(
          MeasureOnTorus(lattice.GetPoint(i), center, lattice.GetSize()), second * (1.0 - 1e-12));
      }
    }
  }
}

TEST(TestRank1Lattice, NearestIsThatOfAllPoints)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> anywhere(-2.0, 3.0);
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (int repeat = 0; repeat < 100; ++repeat)
    {
      // Every fourth at the border, where the basis' cell straddles it.
      const glm::dvec2 uv(repeat % 4 ? anywhere(generator) : 1e-9, anywhere(generator));
      double least = 1e9;
      for (std::int64_t i = 0; i < lattice.GetNumberOfPoints(); ++i)
      {
        least = std::min(least, MeasureOnTorus(lattice.GetPoint(i), uv, lattice.GetSize()));
      }
      const std::int64_t found = lattice.FindNearest(uv);
      ASSERT_GE(found, 0);
      ASSERT_LT(found, lattice.GetNumberOfPoints());
      ASSERT_NEAR(
        MeasureOnTorus(lattice.GetPoint(found), uv, lattice.GetSize()), least, 1e-9 * (1 + least));
    }
  }
}

TEST(TestRank1Lattice, VoronoiCellHasTheAreaAndThePointsNearest)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const auto cell = lattice.GetVoronoiCell();
    double twice = 0.0;
    for (int i = 0; i < 6; ++i)
    {
      const double turn = Cross(cell[i], cell[(i + 1) % 6]);
      EXPECT_GE(turn, -1e-9);
      twice += turn;
      // Corners are as far from 0 as from two other points.
      const glm::dvec2 corner = lattice.ToArea(cell[i]);
      int equal = 0;
      for (int s = -1; s <= 1; ++s)
      {
        for (int t = -1; t <= 1; ++t)
        {
          const glm::dvec2 point = lattice.ToArea(
            glm::dvec2(Vector(s) * lattice.GetBasis(0) + Vector(t) * lattice.GetBasis(1)));
          const double ratio = glm::length(corner - point) / glm::length(corner);
          EXPECT_GE(ratio, 1.0 - 1e-9);
          equal += ratio < 1.0 + 1e-9 ? 1 : 0;
        }
      }
      EXPECT_GE(equal, 3);
    }
    EXPECT_NEAR(0.5 * twice / static_cast<double>(lattice.GetNumberOfPoints()), 1.0, 1e-9);
  }
}

TEST(TestRank1Lattice, DualBasisIsDual)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const auto dual = lattice.GetDualBasis();
    for (int i : { 0, 1 })
    {
      for (int j : { 0, 1 })
      {
        EXPECT_NEAR(
          glm::dot(dual[i], lattice.ToArea(lattice.GetBasis(j))), i == j ? 1.0 : 0.0, 1e-9);
      }
    }
  }
}

TEST(TestRank1Lattice, LargestNumbersFit)
{
  const std::int64_t n = Rank1Lattice::MaximumNumberOfPoints;
  const Rank1Lattice lattice = *Rank1Lattice::Create(n, n - 2, n / 2 + 12345);
  EXPECT_EQ(std::abs(lattice.GetDeterminant()), n);
  for (const std::int64_t i : { std::int64_t{ 1 }, n / 3, n - 1 })
  {
    EXPECT_EQ(lattice.FindNearest(lattice.GetPoint(i)), i);
  }
}

TEST(TestRank1Lattice, RefusesWhatIsNoLattice)
{
  EXPECT_FALSE(Rank1Lattice::Create(0, 1, 1));
  EXPECT_FALSE(Rank1Lattice::Create(-5, 1, 1));
  EXPECT_FALSE(Rank1Lattice::Create(Rank1Lattice::MaximumNumberOfPoints + 1, 1, 1));
  EXPECT_FALSE(Rank1Lattice::Create(8, 2, 4));
  EXPECT_FALSE(Rank1Lattice::Create(8, 0, 0));
  EXPECT_FALSE(Rank1Lattice::Create(7, 14, 7));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { 0.0, -1.0, nan, infinity, 1e9, 1e-300 })
  {
    EXPECT_FALSE(Rank1Lattice::Create(8, 1, 3, { bad, 1.0 })) << bad;
    EXPECT_FALSE(Rank1Lattice::Create(8, 1, 3, { 1.0, bad })) << bad;
  }
  EXPECT_EQ(Rank1Lattice::Create(8, -7, 11)->GetGenerator(), Vector(1, 3));
}
