// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Lattice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bravais
{

//------------------------------------------------------------------------------
Bezout SolveBezout(std::int64_t a, std::int64_t b)
{
  Bezout now{ a, 1, 0 };
  Bezout next{ b, 0, 1 };
  while (next.Divisor != 0)
  {
    const std::int64_t q = now.Divisor / next.Divisor;
    now = { now.Divisor - q * next.Divisor, now.X - q * next.X, now.Y - q * next.Y };
    std::swap(now, next);
  }
  return now.Divisor < 0 ? Bezout{ -now.Divisor, -now.X, -now.Y } : now;
}

//------------------------------------------------------------------------------
bool Rank1Lattice::IsSize(const glm::dvec2& size)
{
  return size.x > 0.0 && size.y > 0.0 && std::isfinite(size.x) && std::isfinite(size.y) &&
    size.x / MaximumAspect <= size.y && size.y / MaximumAspect <= size.x;
}

//------------------------------------------------------------------------------
std::optional<Rank1Lattice> Rank1Lattice::Create(
  std::int64_t n, std::int64_t g1, std::int64_t g2, const glm::dvec2& size)
{
  if (n < 1 || n > MaximumNumberOfPoints || !IsSize(size) ||
    std::gcd(std::gcd(g1 % n, g2 % n), n) != 1)
  {
    return std::nullopt;
  }
  Rank1Lattice lattice;
  lattice.NumberOfPoints = n;
  lattice.Generator = { Modulo(g1, n), Modulo(g2, n) };
  lattice.Size = size;
  lattice.Weights = size / std::min(size.x, size.y);
  lattice.Reduce();
  return lattice;
}

//------------------------------------------------------------------------------
double Rank1Lattice::GetProduct(const Vector& a, const Vector& b) const
{
  return glm::dot(this->Weights * glm::dvec2(a), this->Weights * glm::dvec2(b));
}

//------------------------------------------------------------------------------
void Rank1Lattice::Reduce()
{
  // Hermite's basis, (d, c) and (0, n / d), and the indices of both.
  const std::int64_t n = this->NumberOfPoints;
  const Vector g = this->Generator;
  const Bezout first = SolveBezout(g.x, n);
  const std::int64_t d = first.Divisor;
  const std::int64_t i = Modulo(first.X, n);
  const std::int64_t inverse = Modulo(SolveBezout(g.y, d).X, d); // of g2, modulo d
  Vector a(d, Modulo(i * g.y, n));
  Vector b(0, n / d);
  std::int64_t k = i;
  std::int64_t l = n / d * inverse % n;

  // Gauss: b loses what it has of a, until it is the longer one for good.
  if (this->GetProduct(b, b) < this->GetProduct(a, a))
  {
    std::swap(a, b);
    std::swap(k, l);
  }
  for (;;)
  {
    const double share = this->GetProduct(a, b) / this->GetProduct(a, a);
    const auto turns = static_cast<std::int64_t>(std::floor(share + 0.5));
    b -= turns * a;
    l = Modulo(l - Modulo(turns, n) * k, n);
    if (!(this->GetProduct(b, b) < this->GetProduct(a, a)))
    {
      break;
    }
    std::swap(a, b);
    std::swap(k, l);
  }

  // One of the several bases of this kind.
  const auto turn = [n](Vector& v, std::int64_t& index)
  {
    v = -v;
    index = Modulo(-index, n);
  };
  if (a.x < 0 || (a.x == 0 && a.y < 0))
  {
    turn(a, k);
  }
  const double product = this->GetProduct(a, b);
  if (product < 0.0 || (product == 0.0 && a.x * b.y < a.y * b.x))
  {
    turn(b, l);
  }
  this->Basis = { a, b };
  this->BasisIndices = { k, l };
}

//------------------------------------------------------------------------------
Rank1Lattice::Vector Rank1Lattice::GetGridPoint(std::int64_t i) const
{
  const std::int64_t n = this->NumberOfPoints;
  const std::int64_t rest = Modulo(i, n);
  return { rest * this->Generator.x % n, rest * this->Generator.y % n };
}

//------------------------------------------------------------------------------
glm::dvec2 Rank1Lattice::GetPoint(std::int64_t i) const
{
  return glm::dvec2(this->GetGridPoint(i)) / static_cast<double>(this->NumberOfPoints);
}

//------------------------------------------------------------------------------
glm::dvec2 Rank1Lattice::ToBasis(const glm::dvec2& uv) const
{
  const Vector& a = this->Basis[0];
  const Vector& b = this->Basis[1];
  const double sign = this->GetDeterminant() < 0 ? -1.0 : 1.0;
  return { sign * (uv.x * b.y - uv.y * b.x), sign * (uv.y * a.x - uv.x * a.y) };
}

//------------------------------------------------------------------------------
std::int64_t Rank1Lattice::GetIndex(std::int64_t s, std::int64_t t) const
{
  const std::int64_t n = this->NumberOfPoints;
  return (Modulo(s, n) * this->BasisIndices[0] % n + Modulo(t, n) * this->BasisIndices[1] % n) % n;
}

//------------------------------------------------------------------------------
std::int64_t Rank1Lattice::FindNearest(const glm::dvec2& uv) const
{
  const glm::dvec2 st = this->ToBasis(uv - glm::floor(uv));
  const glm::dvec2 anchor = glm::floor(st);
  glm::dvec2 nearest = anchor;
  double least = -1.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::dvec2 point = anchor + glm::dvec2(corner & 1, corner >> 1);
    const glm::dvec2 rest = st - point;
    const glm::dvec2 away =
      this->Weights * (rest.x * glm::dvec2(this->Basis[0]) + rest.y * glm::dvec2(this->Basis[1]));
    const double distance = glm::dot(away, away);
    if (least < 0.0 || distance < least)
    {
      least = distance;
      nearest = point;
    }
  }
  return this->GetIndex(static_cast<std::int64_t>(nearest.x), static_cast<std::int64_t>(nearest.y));
}

//------------------------------------------------------------------------------
std::array<std::int64_t, 6> Rank1Lattice::GetNeighbors(std::int64_t i) const
{
  const std::int64_t n = this->NumberOfPoints;
  const std::int64_t k = this->BasisIndices[0];
  const std::int64_t l = this->BasisIndices[1];
  const std::int64_t rest = Modulo(i, n);
  return { Modulo(rest + k, n), Modulo(rest + l, n), Modulo(rest + l - k, n), Modulo(rest - k, n),
    Modulo(rest - l, n), Modulo(rest - l + k, n) };
}

//------------------------------------------------------------------------------
double Rank1Lattice::GetMinimumDistance() const
{
  return glm::length(this->ToArea(glm::dvec2(this->Basis[0])));
}

//------------------------------------------------------------------------------
double Rank1Lattice::GetSamplingEfficiency() const
{
  const double pi = glm::radians(180.0);
  const double area = this->Weights.x * this->Weights.y * static_cast<double>(this->NumberOfPoints);
  return pi * this->GetProduct(this->Basis[0], this->Basis[0]) / (4.0 * area);
}

//------------------------------------------------------------------------------
std::array<glm::dvec2, 6> Rank1Lattice::GetVoronoiCell() const
{
  // Centres of the circles through 0 and two neighbours one after the other, of three; the rest
  // are opposite.
  const bool left = this->GetDeterminant() > 0;
  const glm::dvec2 a = this->Weights * glm::dvec2(this->Basis[0]);
  const glm::dvec2 b = this->Weights * glm::dvec2(this->Basis[1]);
  const std::array<glm::dvec2, 4> around = left ? std::array<glm::dvec2, 4>{ a, b, b - a, -a }
                                                : std::array<glm::dvec2, 4>{ b, a, a - b, -b };
  std::array<glm::dvec2, 6> cell;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec2 p = around[i];
    const glm::dvec2 q = around[i + 1];
    const double twice = 2.0 * (p.x * q.y - p.y * q.x);
    const double pp = glm::dot(p, p);
    const double qq = glm::dot(q, q);
    const glm::dvec2 center((q.y * pp - p.y * qq) / twice, (p.x * qq - q.x * pp) / twice);
    cell[i] = center / this->Weights;
    cell[i + 3] = -cell[i];
  }
  return cell;
}

//------------------------------------------------------------------------------
std::array<glm::dvec2, 2> Rank1Lattice::GetDualBasis() const
{
  const double sign = this->GetDeterminant() < 0 ? -1.0 : 1.0;
  const glm::dvec2 a = sign * glm::dvec2(this->Basis[0]);
  const glm::dvec2 b = sign * glm::dvec2(this->Basis[1]);
  return { glm::dvec2(b.y, -b.x) / this->Size, glm::dvec2(-a.y, a.x) / this->Size };
}

} // namespace bravais
