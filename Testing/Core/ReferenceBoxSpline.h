// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBoxSpline_h
#define ReferenceBoxSpline_h

#include "BCCKernel.h"

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace bravais
{

/// A kernel by the definition of its box-spline, slowly. With x the sum of t_d d over the
/// directions d,
///
///     (m - 3) M(x) = sum over d of t_d M_d(x) + (k_d - t_d) M_d(x - d),
///
/// where d is taken k_d times and M_d has it once less (de Boor and Hollig, B-splines from
/// parallelepipeds), down to three directions: 1 / |det| on their half-open parallelepiped.
///
/// What is inside is decided exactly, in integers, for points that are multiples of 1 / Unit: that
/// lets points lie on knot planes, where the lower splines jump and the sides must be consistent.
class ReferenceBoxSpline
{
public:
  static constexpr std::int64_t Unit = 1 << 20;

  explicit ReferenceBoxSpline(BCCKernel kernel)
  {
    const int s1 = kernel == BCCKernel::BCC8 ? 2 : kernel == BCCKernel::BCC12 ? 0 : 1;
    const int s2 = kernel == BCCKernel::BCC7 ? 1 : kernel == BCCKernel::BCC12 ? 4 : 0;
    this->Multiplicities = { s1, s1, s1, s1, s2, s2, s2 };
  }

  /// The nearest point at which the spline can be evaluated.
  static glm::dvec3 Round(const glm::dvec3& p)
  {
    const auto unit = static_cast<double>(Unit);
    return { std::round(p.x * unit) / unit, std::round(p.y * unit) / unit,
      std::round(p.z * unit) / unit };
  }

  /// The kernel centred at 0, scaled to sum to 1 over the lattice. p is one of Round's points.
  double operator()(const glm::dvec3& p)
  {
    this->Values.clear();
    // The recurrence's box-spline starts at 0; half the sum of the directions is its centre.
    for (int q = 0; q < 3; ++q)
    {
      std::int64_t twice = 0;
      for (std::size_t d = 0; d < 7; ++d)
      {
        twice += this->Multiplicities[d] * Directions[d][q];
      }
      this->Point[q] = static_cast<std::int64_t>(std::llround(p[q] * Unit)) + twice * Unit / 2;
    }
    return static_cast<double>(4.0L * this->Evaluate(this->Multiplicities, {}));
  }

private:
  using Counts = std::array<int, 7>;
  using Vector = glm::vec<3, std::int64_t>;

  static constexpr std::int64_t Directions[7][3] = { { -1, 1, 1 }, { 1, -1, 1 }, { 1, 1, -1 },
    { -1, -1, -1 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };

  static Vector GetDirection(std::size_t d)
  {
    return { Directions[d][0], Directions[d][1], Directions[d][2] };
  }

  static std::int64_t Det(const Vector& a, const Vector& b, const Vector& c)
  {
    return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
      a.z * (b.x * c.y - b.y * c.x);
  }

  /// Where a coordinate in units of 1 / one lies, if the point were moved a little along `shift`:
  /// a multiple of one counts as the side it is moved to.
  static bool IsInside(std::int64_t t, std::int64_t shift, std::int64_t one)
  {
    return (t > 0 || (t == 0 && shift > 0)) && (t < one || (t == one && shift < 0));
  }

  /// The box-spline of these directions at Point less `shifts` times the directions.
  long double Evaluate(const Counts& counts, const Counts& shifts)
  {
    const auto key = std::make_pair(counts, shifts);
    const auto known = this->Values.find(key);
    if (known != this->Values.end())
    {
      return known->second;
    }
    return this->Values[key] = this->Compute(counts, shifts);
  }

  long double Compute(const Counts& counts, const Counts& shifts)
  {
    Vector x = this->Point;
    std::vector<std::size_t> used;
    int total = 0;
    for (std::size_t d = 0; d < 7; ++d)
    {
      x -= static_cast<std::int64_t>(shifts[d]) * Unit * GetDirection(d);
      total += counts[d];
      if (counts[d] > 0)
      {
        used.push_back(d);
      }
    }
    std::array<std::size_t, 3> basis = {};
    std::int64_t volume = 0;
    for (std::size_t a = 0; a < used.size() && volume == 0; ++a)
    {
      for (std::size_t b = a + 1; b < used.size() && volume == 0; ++b)
      {
        for (std::size_t c = b + 1; c < used.size() && volume == 0; ++c)
        {
          basis = { used[a], used[b], used[c] };
          volume = Det(GetDirection(used[a]), GetDirection(used[b]), GetDirection(used[c]));
        }
      }
    }
    if (volume == 0)
    {
      return 0.0L; // Directions in a plane: nothing off it, and Point counts as off all planes.
    }
    const std::int64_t sign = volume < 0 ? -1 : 1;
    const Vector aside(1, 3, 10); // in no plane that two of the directions span
    const std::int64_t one = sign * volume * Unit;
    std::array<std::int64_t, 7> t = {};
    bool inside = true;
    for (std::size_t n = 0; n < 3; ++n)
    {
      const auto replace = [&](const Vector& v)
      {
        Vector columns[3] = { GetDirection(basis[0]), GetDirection(basis[1]),
          GetDirection(basis[2]) };
        columns[n] = v;
        return sign * Det(columns[0], columns[1], columns[2]);
      };
      t[basis[n]] = replace(x);
      inside = inside && IsInside(t[basis[n]], replace(aside), one);
    }
    if (total == 3)
    {
      return inside ? 1.0L / static_cast<long double>(sign * volume) : 0.0L;
    }
    long double sum = 0.0L;
    for (const std::size_t d : used)
    {
      Counts fewer = counts;
      --fewer[d];
      Counts shifted = shifts;
      ++shifted[d];
      const std::int64_t far = counts[d] * one - t[d];
      sum += static_cast<long double>(t[d]) * this->Evaluate(fewer, shifts);
      sum += static_cast<long double>(far) * this->Evaluate(fewer, shifted);
    }
    return sum / (static_cast<long double>(one) * (total - 3));
  }

  Counts Multiplicities;
  Vector Point;
  std::map<std::pair<Counts, Counts>, long double> Values;
};

} // namespace bravais

#endif
