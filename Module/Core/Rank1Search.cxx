// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bravais
{

namespace
{

using Vector = Rank1Lattice::Vector;

constexpr double Equal = 1e-12; ///< relative difference of squared lengths that counts as none

std::int64_t Round(double x)
{
  return static_cast<std::int64_t>(std::floor(x + 0.5));
}

/// Searches rings of vectors for the lattices with a shortest vector in it.
class Search
{
public:
  Search(std::int64_t n, const glm::dvec2& weights)
    : NumberOfPoints(n)
    , Weights(weights)
  {
  }

  /// Looks at all vectors of squared length first to last; mirror images give mirror images.
  void TryRing(double first, double last)
  {
    // Rows along the axis that has more points.
    const int along = this->Weights.x < this->Weights.y ? 0 : 1;
    const int across = 1 - along;
    const double step = this->Weights[across];
    const double slack = 1e-6; // rounding at the ends; vectors beyond do no harm
    const std::int64_t rows = static_cast<std::int64_t>(std::sqrt(last) / step + slack);
    for (std::int64_t row = 0; row <= rows; ++row)
    {
      const double height = step * static_cast<double>(row);
      const auto reach = [&](double square)
      { return std::sqrt(std::max(0.0, square - height * height)) / this->Weights[along]; };
      Vector v;
      v[across] = row;
      const auto from = static_cast<std::int64_t>(std::ceil(reach(first) - slack));
      const auto to = static_cast<std::int64_t>(std::floor(reach(last) + slack));
      for (v[along] = std::max(from, std::int64_t{ row == 0 ? 1 : 0 }); v[along] <= to; ++v[along])
      {
        this->TryVector(v);
      }
    }
  }

  double GetBest() const { return this->Best; }

  /// Least generator of the lattices found.
  const Vector& GetGenerator() const { return this->Generator; }

private:
  double GetProduct(const Vector& a, const Vector& b) const
  {
    const double x = this->Weights.x * this->Weights.x;
    const double y = this->Weights.y * this->Weights.y;
    return x * static_cast<double>(a.x * b.x) + y * static_cast<double>(a.y * b.y);
  }

  bool IsAtLeast(const Vector& w, double length) const
  {
    return this->GetProduct(w, w) >= length * (1.0 - 0.1 * Equal);
  }

  /// The lattices of which v is a shortest vector.
  void TryVector(const Vector& v)
  {
    const std::int64_t n = this->NumberOfPoints;
    const double length = this->GetProduct(v, v);
    if (length < this->Best * (1.0 - Equal))
    {
      return;
    }
    const Bezout bezout = SolveBezout(v.x, v.y);
    const std::int64_t g = bezout.Divisor;
    if (n % g != 0)
    {
      return;
    }
    const Vector p = v / g;
    const std::int64_t m = n / g;
    Vector w = m * Vector(-bezout.Y, bezout.X); // det(v, w) = n
    w -= Round(this->GetProduct(p, w) / this->GetProduct(p, p)) * p;
    // w is the nearest to the middle of its line; g steps of p make one of v.
    for (std::int64_t turn = -(g / 2) - 1; turn <= g / 2 + 1; ++turn)
    {
      const Vector other = w + turn * p;
      if (std::gcd(g, std::gcd(other.x, other.y)) == 1 && this->IsAtLeast(other, length) &&
        this->IsAtLeast(other - v, length) && this->IsAtLeast(other + v, length))
      {
        this->Keep(v, other, length);
        this->Keep(Vector(v.x, -v.y), Vector(other.x, -other.y), length);
      }
    }
  }

  /// Takes note of the lattice of a basis.
  void Keep(const Vector& v, const Vector& w, double length)
  {
    // Hermite's basis is (d, c) and (0, n / d); generators with g1 = d differ by the latter.
    const std::int64_t n = this->NumberOfPoints;
    const Bezout bezout = SolveBezout(v.x, w.x);
    const std::int64_t d = bezout.Divisor;
    const std::int64_t c = Modulo(
      Modulo(bezout.X, n) * Modulo(v.y, n) % n + Modulo(bezout.Y, n) * Modulo(w.y, n) % n, n / d);
    Vector generator(d, c);
    while (std::gcd(d, generator.y) != 1)
    {
      generator.y += n / d;
    }
    const bool better = length > this->Best * (1.0 + Equal);
    if (better || generator.x < this->Generator.x ||
      (generator.x == this->Generator.x && generator.y < this->Generator.y))
    {
      this->Generator = generator;
    }
    this->Best = std::max(this->Best, length);
  }

  std::int64_t NumberOfPoints;
  glm::dvec2 Weights;
  double Best = 0.0;
  Vector Generator = { 0, 0 };
};

/// Distance in memory of a step by an index.
std::int64_t GetDistance(std::int64_t index, std::int64_t n)
{
  return std::min(index, n - index);
}

/// The shortest vector whose index generates all others, and of vectors of one pair of neighbours'
/// length the one that leaves the other neighbours nearest in memory; its index.
std::int64_t FindShortestGenerator(const Rank1Lattice& lattice)
{
  const std::int64_t n = lattice.GetNumberOfPoints();
  const auto six = lattice.GetNeighbors(0);
  std::int64_t best = -1;
  std::int64_t least = n;
  for (int i = 0; i < 3; ++i)
  {
    const Bezout bezout = SolveBezout(six[i], n);
    if (bezout.Divisor == 1)
    {
      const std::int64_t inverse = Modulo(bezout.X, n);
      std::int64_t farthest = 0;
      for (int j = 0; j < 3; ++j)
      {
        farthest = std::max(farthest, GetDistance(six[j] * inverse % n, n));
      }
      if (best < 0 || farthest < least)
      {
        best = six[i];
        least = farthest;
      }
    }
  }
  // Beyond the neighbours, ever larger diamonds of the basis.
  for (std::int64_t ring = 2; best < 0; ++ring)
  {
    double shortest = -1.0;
    for (std::int64_t s = -ring; s <= ring; ++s)
    {
      const std::int64_t t = ring - std::abs(s);
      const std::int64_t index = lattice.GetIndex(s, t);
      const glm::dvec2 v =
        lattice.ToArea(glm::dvec2(s * lattice.GetBasis(0) + t * lattice.GetBasis(1)));
      const double length = v.x * v.x + v.y * v.y;
      if (std::gcd(index, n) == 1 && (shortest < 0.0 || length < shortest))
      {
        shortest = length;
        best = index;
      }
    }
  }
  return best;
}

} // namespace

//------------------------------------------------------------------------------
std::optional<Rank1Lattice> MaximizeMinimumDistance(
  std::int64_t n, const glm::dvec2& size, Rank1Layout layout)
{
  if (n < 1 || n > Rank1Lattice::MaximumNumberOfPoints || !Rank1Lattice::IsSize(size))
  {
    return std::nullopt;
  }
  const glm::dvec2 weights = size / std::min(size.x, size.y);
  const auto count = static_cast<double>(n);
  // Hermite's bound; and a copy of a point is one area's side away.
  const double bound =
    std::min(2.0 / std::sqrt(3.0) * count * weights.x * weights.y, count * count);
  Search search(n, weights);
  double last = bound;
  double width = std::min(0.5, 4.0 / std::sqrt(count)); // of a ring, relative
  while (!(search.GetBest() >= last))
  {
    const double first = last * (1.0 - width);
    // A little more, so that what equals the ring's last is in it.
    search.TryRing(first * (1.0 - 2.0 * Equal), last);
    last = first;
    width = std::min(0.5, 2.0 * width);
  }
  const Vector& g = search.GetGenerator();
  const auto lattice = Rank1Lattice::Create(n, g.x, g.y, size);
  return lattice && layout == Rank1Layout::Locality ? ChooseGenerator(*lattice, layout) : lattice;
}

//------------------------------------------------------------------------------
Rank1Lattice ChooseGenerator(const Rank1Lattice& lattice, Rank1Layout layout)
{
  const std::int64_t n = lattice.GetNumberOfPoints();
  Vector g = lattice.GetGenerator();
  if (layout == Rank1Layout::Locality)
  {
    g = lattice.GetGridPoint(n == 1 ? 0 : FindShortestGenerator(lattice));
  }
  else
  {
    const Bezout bezout = SolveBezout(g.x, n);
    const std::int64_t d = bezout.Divisor;
    g = { d, Modulo(Modulo(bezout.X, n) * g.y % n, n / d) };
    while (std::gcd(d, g.y) != 1)
    {
      g.y += n / d;
    }
  }
  return *Rank1Lattice::Create(n, g.x, g.y, lattice.GetSize());
}

//------------------------------------------------------------------------------
double MeasureLayout(const Rank1Lattice& lattice, int line)
{
  const auto six = lattice.GetNeighbors(0);
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t distance = GetDistance(six[i], lattice.GetNumberOfPoints());
    sum += std::min(1.0, static_cast<double>(distance) / line);
  }
  return sum / 3.0;
}

} // namespace bravais
