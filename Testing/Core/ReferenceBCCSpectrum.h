// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceBCCSpectrum_h
#define ReferenceBCCSpectrum_h

#include "BCCPrefilter.h"
#include "BCCPrefilterTables.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

/// The prefilters' frequency responses as they are written, slowly.
namespace bravais
{

constexpr double ReferencePi = 3.14159265358979323846;

constexpr BCCKernel ReferenceKernels[] = { BCCKernel::BCC4, BCCKernel::BCC7, BCCKernel::BCC8,
  BCCKernel::BCC12 };

inline double ReferenceSinc(double t)
{
  return t == 0.0 ? 1.0 : std::sin(t) / t;
}

/// The kernel's Fourier transform at any w, 1 at 0.
inline double ReferenceTransform(BCCKernel kernel, const glm::dvec3& w)
{
  double diagonals = 1.0;
  double axes = 1.0;
  for (const glm::dvec3& d :
    { glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1) })
  {
    diagonals *= ReferenceSinc(0.5 * glm::dot(w, d));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    axes *= ReferenceSinc(w[axis]);
  }
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return diagonals;
    case BCCKernel::BCC7:
      return diagonals * axes;
    case BCCKernel::BCC8:
      return diagonals * diagonals;
    case BCCKernel::BCC12:
      break;
  }
  return std::pow(axes, 4);
}

inline std::vector<BCCOrbit> GetReferenceTable(BCCKernel kernel, BCCPrefilter prefilter)
{
  const auto copy = [](const auto& t) { return std::vector(std::begin(t), std::end(t)); };
  const bool samples = prefilter == BCCPrefilter::Interpolation;
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return samples ? copy(BCC4Samples) : copy(BCC4Autocorrelation);
    case BCCKernel::BCC7:
      return samples ? copy(BCC7Samples) : copy(BCC7Autocorrelation);
    case BCCKernel::BCC8:
      return samples ? copy(BCC8Samples) : copy(BCC8Autocorrelation);
    case BCCKernel::BCC12:
      break;
  }
  return samples ? copy(BCC12Samples) : copy(BCC12Autocorrelation);
}

/// The value of a table at any lattice point.
inline double ReferenceLookUp(const std::vector<BCCOrbit>& table, const glm::ivec3& point)
{
  std::array<int, 3> p = { std::abs(point.x), std::abs(point.y), std::abs(point.z) };
  std::sort(p.begin(), p.end());
  for (const BCCOrbit& orbit : table)
  {
    if (orbit.X == p[2] && orbit.Y == p[1] && orbit.Z == p[0])
    {
      return orbit.Value;
    }
  }
  return 0.0;
}

/// Calls function(point, value) for all lattice points where a table is not 0.
template <class F>
void ForEachReferencePoint(const std::vector<BCCOrbit>& table, F&& function)
{
  for (int n = 0; n < 17 * 17 * 17; ++n)
  {
    const glm::ivec3 point = glm::ivec3(n % 17, n / 17 % 17, n / 289) - 8;
    const double value = ReferenceLookUp(table, point);
    if (value != 0.0)
    {
      function(point, value);
    }
  }
}

/// The sum of the table's values times exp(-i w.j).
inline double ReferenceSymbol(const std::vector<BCCOrbit>& table, const glm::dvec3& w)
{
  double sum = 0.0;
  ForEachReferencePoint(table,
    [&](const glm::ivec3& point, double value)
    { sum += value * std::cos(glm::dot(w, glm::dvec3(point))); });
  return sum;
}

/// Q(w), with 0 where the autocorrelation's symbol vanishes.
inline double ReferenceResponse(BCCKernel kernel, BCCPrefilter prefilter, const glm::dvec3& w)
{
  const double symbol = ReferenceSymbol(GetReferenceTable(kernel, prefilter), w);
  if (prefilter == BCCPrefilter::Interpolation)
  {
    return 1.0 / symbol;
  }
  glm::dvec3 nearest = w; // of w + 2 pi k, k in the dual lattice
  for (int n = 0; n < 7 * 7 * 7; ++n)
  {
    const glm::ivec3 shift = glm::ivec3(n % 7, n / 7 % 7, n / 49) - 3;
    const glm::dvec3 candidate = w + ReferencePi * glm::dvec3(shift);
    if ((shift.x + shift.y + shift.z) % 2 == 0 &&
      glm::dot(candidate, candidate) < glm::dot(nearest, nearest))
    {
      nearest = candidate;
    }
  }
  return symbol < 1e-14 ? 0.0 : ReferenceTransform(kernel, nearest) / symbol;
}

} // namespace bravais

#endif
