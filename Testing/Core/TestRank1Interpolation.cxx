// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Rank1BoxSpline.h"
#include "Rank1Testing.h"

#include <gtest/gtest.h>

#include <random>

using namespace bravais;

namespace
{

template <class T>
struct Taps
{
  Rank1Integer<T> Texels[12];
  T Weights[12];
  int Count;
};

/// Mode 0 nearest, 1 bilinear, 2 barycentric, 3 box-spline.
template <class T>
Taps<T> Find(const Rank1Texture<T>& texture, const glm::dvec2& uv, int mode)
{
  Taps<T> taps{};
  const glm::vec<2, T> p(uv);
  taps.Count = std::array<int, 4>{ 1, 4, 3, 12 }[mode];
  switch (mode)
  {
    case 0:
      taps.Texels[0] = FindRank1Nearest(texture, p);
      taps.Weights[0] = T(1);
      break;
    case 1:
      FindRank1Bilinear(texture, p, taps.Texels, taps.Weights);
      break;
    case 2:
      FindRank1Barycentric(texture, p, taps.Texels, taps.Weights);
      break;
    default:
      FindRank1BoxSpline(texture, p, taps.Texels, taps.Weights);
  }
  return taps;
}

/// Where in the picture, 0 to 1, a texel is.
glm::dvec2 Place(const Rank1Lattice& lattice, glm::ivec2 tiles, std::int64_t texel)
{
  const std::int64_t n = lattice.GetNumberOfPoints();
  const std::int64_t tile = texel / n;
  const glm::dvec2 corner(static_cast<double>(tile % tiles.x), static_cast<double>(tile / tiles.x));
  return (corner + lattice.GetPoint(texel % n)) / glm::dvec2(tiles);
}

glm::dvec2 NearCopy(const glm::dvec2& v)
{
  return v - glm::floor(v + 0.5);
}

std::vector<glm::dvec2> MakePoints(int count)
{
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::vector<glm::dvec2> points = { { 0.0, 0.0 }, { 1.0, 1.0 }, { -0.25, 7.5 },
    { 0.5, 0.999999 } };
  while (static_cast<int>(points.size()) < count)
  {
    points.emplace_back(anywhere(generator), anywhere(generator));
  }
  return points;
}

/// The three-direction box-spline on the lattice of integers, directions (1, 0), (0, 1), (-1, 1)
/// twice each, at (x, y): averages along the directions of the one of fewer.
double ConvolveBoxSpline(const glm::dvec2& p)
{
  // The Courant element: linear on the triangles, 1 at 0.
  const auto courant = [](double x, double y)
  {
    const double f = std::max({ std::abs(x), std::abs(y), std::abs(x + y) });
    return std::max(0.0, 1.0 - f);
  };
  // Averaged along each direction, symmetrically, by a Gauss rule on pieces.
  constexpr int steps = 60;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; j < steps; ++j)
    {
      for (int k = 0; k < steps; ++k)
      {
        const double a = (i + 0.5) / steps - 0.5;
        const double b = (j + 0.5) / steps - 0.5;
        const double c = (k + 0.5) / steps - 0.5;
        sum += courant(p.x - a + c, p.y - b - c);
      }
    }
  }
  return sum / (steps * steps * steps);
}

/// The box-spline of one texel at a place in the basis of the integers' lattice.
double EvaluateByWeights(const glm::dvec2& p)
{
  Rank1Site<double> site;
  const glm::dvec2 cell = glm::floor(p);
  site.Tile = { 0, 0 };
  site.Cell = glm::vec<2, std::int64_t>(cell);
  site.Fraction = p - cell;
  const Rank1Triangle<double> triangle = FindRank1Triangle(site);
  double weights[12];
  EvaluateRank1BoxSpline(triangle.Barycentric, weights);
  const int stencil[12][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { -1, 1 }, { 1, -1 },
    { -1, 0 }, { 0, -1 }, { 2, -1 }, { 2, 0 }, { 0, 2 }, { -1, 2 } };
  double value = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    const std::int64_t x = triangle.Corner.x + triangle.Sign * stencil[i][0];
    const std::int64_t y = triangle.Corner.y + triangle.Sign * stencil[i][1];
    value += x == 0 && y == 0 ? weights[i] : 0.0;
  }
  return value;
}

template <class T>
void CheckModes(const Rank1Lattice& lattice, glm::ivec2 tiles, double tolerance)
{
  const Rank1Texture<T> texture = MakeRank1Texture<T>(lattice, tiles.x, tiles.y);
  const std::int64_t texels = lattice.GetNumberOfPoints() * tiles.x * tiles.y;
  // Only where stencils are small in a tile is the nearest copy of a texel the one that was meant.
  const bool compact = lattice.GetNumberOfPoints() > 90 && lattice.GetSize().x < 100.0 &&
    lattice.GetSamplingEfficiency() > 0.3;
  for (const glm::dvec2& uv : MakePoints(60))
  {
    for (int mode = 0; mode < 4; ++mode)
    {
      const Taps<T> taps = Find(texture, uv, mode);
      double sum = 0.0;
      glm::dvec2 moment(0.0);
      for (int i = 0; i < taps.Count; ++i)
      {
        ASSERT_GE(taps.Texels[i], 0);
        ASSERT_LT(taps.Texels[i], texels);
        ASSERT_GE(taps.Weights[i], -1e-6);
        const glm::dvec2 away = NearCopy(Place(lattice, tiles, taps.Texels[i]) - uv);
        sum += taps.Weights[i];
        moment += static_cast<double>(taps.Weights[i]) * away;
      }
      ASSERT_NEAR(sum, 1.0, 1e-5);
      // Linear functions are reproduced: the mean of the texels' places is the point itself.
      if (mode > 0 && compact)
      {
        ASSERT_NEAR(moment.x, 0.0, tolerance) << mode;
        ASSERT_NEAR(moment.y, 0.0, tolerance) << mode;
      }
    }
  }
}

} // namespace

TEST(TestRank1Interpolation, WeightsSumToOneAndReproduceLinearFunctions)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    for (const glm::ivec2 tiles : { glm::ivec2(1, 1), glm::ivec2(3, 2), glm::ivec2(1, 7) })
    {
      CheckModes<double>(lattice, tiles, 1e-12);
      CheckModes<float>(lattice, tiles, 2e-6);
    }
  }
}

TEST(TestRank1Interpolation, StencilsAreCompactOnOrdinaryLattices)
{
  // So that the test above has looked at something: with tiles, and across their edges.
  const Rank1Lattice lattice = *Rank1Lattice::Create(256, 1, 30);
  const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice, 3, 2);
  for (const glm::dvec2& uv : MakePoints(300))
  {
    const Taps<double> taps = Find(texture, uv, 3);
    for (int i = 0; i < 12; ++i)
    {
      const glm::dvec2 away =
        NearCopy(Place(lattice, { 3, 2 }, taps.Texels[i]) - uv) * glm::dvec2(3.0, 2.0);
      EXPECT_LT(glm::length(away), 3.0 * lattice.GetMinimumDistance());
    }
  }
}

TEST(TestRank1Interpolation, NearestIsThatOfTheLattice)
{
  for (const Rank1Lattice& lattice : MakeRank1Lattices())
  {
    const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice);
    for (const glm::dvec2& uv : MakePoints(60))
    {
      const glm::dvec2 found = lattice.GetPoint(FindRank1Nearest(texture, uv));
      const glm::dvec2 expected = lattice.GetPoint(lattice.FindNearest(uv));
      EXPECT_NEAR(MeasureOnTorus(found, uv, lattice.GetSize()),
        MeasureOnTorus(expected, uv, lattice.GetSize()), 1e-12);
    }
  }
}

TEST(TestRank1Interpolation, NearestOfTilesLooksBeyondTheEdge)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(97, 5, 31);
  const glm::ivec2 tiles(3, 2);
  const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice, 3, 2);
  for (const glm::dvec2& uv : MakePoints(400))
  {
    double least = 1e9;
    for (std::int64_t texel = 0; texel < 97 * 6; ++texel)
    {
      least = std::min(
        least, glm::length(NearCopy(Place(lattice, tiles, texel) - uv) * glm::dvec2(tiles)));
    }
    const std::int64_t found = FindRank1Nearest(texture, uv);
    EXPECT_NEAR(
      glm::length(NearCopy(Place(lattice, tiles, found) - uv) * glm::dvec2(tiles)), least, 1e-12);
  }
}

TEST(TestRank1Interpolation, DependsOnTheAreasShapeAlone)
{
  const auto unit = MakeRank1Texture<double>(*Rank1Lattice::Create(97, 5, 31, { 1.0, 0.5 }));
  for (const double scale : { 1e-300, 3.0, 1e300 })
  {
    const auto scaled =
      MakeRank1Texture<double>(*Rank1Lattice::Create(97, 5, 31, scale * glm::dvec2(1.0, 0.5)));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(scaled.Metric[i], unit.Metric[i], 1e-12);
    }
  }
}

TEST(TestRank1Interpolation, InterpolatesItsTexels)
{
  const Rank1Lattice lattice = *Rank1Lattice::Create(256, 1, 30);
  const Rank1Texture<double> texture = MakeRank1Texture<double>(lattice);
  for (std::int64_t texel = 0; texel < 256; ++texel)
  {
    for (int mode = 0; mode < 3; ++mode)
    {
      const Taps<double> taps = Find(texture, lattice.GetPoint(texel), mode);
      double own = 0.0;
      for (int i = 0; i < taps.Count; ++i)
      {
        own += taps.Texels[i] == texel ? taps.Weights[i] : 0.0;
      }
      EXPECT_NEAR(own, 1.0, 1e-12);
    }
  }
}

TEST(TestRank1Interpolation, FloatFindsTheTexelsOfDoubleUpTo2To24)
{
  for (const std::int64_t n : { 1 << 24, (1 << 24) - 3, 3000000 })
  {
    // One in Korobov form, one not, both with cells that are no slivers.
    const auto make = [n](std::int64_t g1)
    {
      for (std::int64_t g2 = n / 3;; ++g2)
      {
        const auto lattice = Rank1Lattice::Create(n, g1, g2);
        if (lattice && lattice->GetSamplingEfficiency() > 0.7)
        {
          return *lattice;
        }
      }
    };
    for (const Rank1Lattice& each : { make(1), make(n / 2 + 3) })
    {
      const Rank1Texture<float> shader = MakeRank1Texture<float>(each);
      const Rank1Texture<double> exact = MakeRank1Texture<double>(each);
      int different = 0;
      for (const glm::dvec2& uv : MakePoints(2000))
      {
        const glm::dvec2 point = glm::dvec2(glm::vec2(uv)); // what a float can say
        const auto index = each.GetIndex(exact.Indices.x % 1000, exact.Indices.y % 1000);
        EXPECT_EQ(
          Rank1Index<float>(shader,
            { static_cast<int>(exact.Indices.x % 1000), static_cast<int>(exact.Indices.y % 1000) }),
          index);
        different += FindRank1Nearest(shader, glm::vec2(point)) != FindRank1Nearest(exact, point);
      }
      EXPECT_LT(different, 20); // those within rounding of a cell's edge
    }
  }
}

TEST(TestRank1Interpolation, BoxSplineIsTheConvolution)
{
  for (const glm::dvec2& p :
    { glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.3, 0.1), glm::dvec2(-0.6, 0.8),
      glm::dvec2(0.7, 0.7), glm::dvec2(-1.2, 1.4), glm::dvec2(1.1, -1.5) })
  {
    EXPECT_NEAR(EvaluateByWeights(p), ConvolveBoxSpline(p), 2e-4) << p.x << " " << p.y;
  }
  EXPECT_NEAR(EvaluateByWeights({ 0.0, 0.0 }), 0.5, 1e-15);
  EXPECT_NEAR(EvaluateByWeights({ -1.0, 1.0 }), 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(EvaluateByWeights({ 1.0, 1.0 }), 0.0, 1e-15);
}

TEST(TestRank1Interpolation, BoxSplineIsTwiceDifferentiable)
{
  // Third differences over an edge of the triangles are small by one more power than where a second
  // derivative jumps.
  const auto largest = [](double h)
  {
    double worst = 0.0;
    for (const glm::dvec2& p : MakePoints(200))
    {
      for (const glm::dvec2 step : { glm::dvec2(h, 0.0), glm::dvec2(0.4 * h, h) })
      {
        const glm::dvec2 q = 4.0 * glm::fract(p) - 2.0;
        const auto at = [&](int i) { return EvaluateByWeights(q + double(i) * step); };
        worst = std::max(worst, std::abs(at(3) - 3.0 * at(2) + 3.0 * at(1) - at(0)) / (h * h));
      }
    }
    return worst;
  };
  EXPECT_LT(largest(0.001), 0.6 * largest(0.002));
  EXPECT_LT(largest(0.0005), 0.6 * largest(0.001));
}

TEST(TestRank1Interpolation, BoxSplineKeepsCubicsButForALowerOne)
{
  // s(f) - f of a cubic f is a polynomial of two degrees less: of x^3 it is x, of x^2 constant.
  const auto spline = [](const glm::dvec2& p, auto f)
  {
    double sum = 0.0;
    const glm::ivec2 middle(glm::floor(p));
    for (int x = -3; x <= 4; ++x)
    {
      for (int y = -3; y <= 4; ++y)
      {
        const glm::dvec2 j(middle + glm::ivec2(x, y));
        sum += f(j) * EvaluateByWeights(p - j);
      }
    }
    return sum;
  };
  for (const glm::dvec2& p : MakePoints(40))
  {
    const auto square = [](const glm::dvec2& v) { return v.x * v.x; };
    const auto cube = [](const glm::dvec2& v) { return v.x * v.x * v.x; };
    EXPECT_NEAR(spline(p, square) - square(p), 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(spline(p, cube) - cube(p), p.x, 1e-10);
  }
}
