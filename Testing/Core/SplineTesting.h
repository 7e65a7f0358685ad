// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SplineTesting_h
#define SplineTesting_h

/// \file
/// What the tests of the splines share: kernels, points and coefficients.

#include "BCCLattice.h"
#include "BoxSpline.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace bravais
{

constexpr BCCKernel AllKernels[] = { BCCKernel::BCC4, BCCKernel::BCC7, BCCKernel::BCC8,
  BCCKernel::BCC12 };

/// A kernel's number of lattice points that reach a generic point.
inline std::size_t GetStencilSize(BCCKernel kernel)
{
  return kernel == BCCKernel::BCC4 ? 4
    : kernel == BCCKernel::BCC7    ? 30
    : kernel == BCCKernel::BCC8    ? 32
                                   : 128;
}

/// The number of derivatives that a kernel has everywhere.
inline int GetSmoothness(BCCKernel kernel)
{
  return kernel == BCCKernel::BCC4 ? 0 : 2;
}

/// A coefficient between -1 and 1 for every lattice point, without pattern.
inline double GetCoefficient(const glm::ivec3& p)
{
  auto h = static_cast<std::uint32_t>(p.x) * 73856093u ^
    static_cast<std::uint32_t>(p.y) * 19349663u ^ static_cast<std::uint32_t>(p.z) * 83492791u;
  h = (h ^ (h >> 15)) * 2246822519u;
  h = (h ^ (h >> 13)) * 3266489917u;
  return static_cast<double>((h ^ (h >> 16)) >> 8) / 8388608.0 - 1.0;
}

/// Random points with coordinates between -reach and reach.
inline std::vector<glm::dvec3> MakePoints(int count, double reach)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  std::vector<glm::dvec3> points;
  for (int n = 0; n < count; ++n)
  {
    const double x = uniform(generator);
    const double y = uniform(generator);
    points.emplace_back(x, y, uniform(generator));
  }
  return points;
}

/// Random points on knot planes, lines and vertices: multiples of 1/4 between -reach and reach.
inline std::vector<glm::dvec3> MakeKnotPoints(int count, double reach)
{
  auto points = MakePoints(count, 4.0 * reach);
  for (glm::dvec3& p : points)
  {
    p = 0.25 * glm::round(p);
  }
  return points;
}

/// The lattice points with coordinates between -reach and reach.
inline std::vector<glm::ivec3> MakeLatticePoints(int reach)
{
  std::vector<glm::ivec3> points;
  for (int z = -reach; z <= reach; ++z)
  {
    for (int y = -reach; y <= reach; ++y)
    {
      for (int x = -reach; x <= reach; ++x)
      {
        if (BCCLattice::IsPoint({ x, y, z }))
        {
          points.emplace_back(x, y, z);
        }
      }
    }
  }
  return points;
}

/// The 48 symmetries of the cube: a permutation of the axes and a sign for each.
struct CubeSymmetry
{
  glm::ivec3 Axes;
  glm::ivec3 Signs;

  template <class V>
  V operator()(const V& p) const
  {
    V q;
    for (int n = 0; n < 3; ++n)
    {
      q[n] = static_cast<typename V::value_type>(this->Signs[n]) * p[this->Axes[n]];
    }
    return q;
  }

  /// The symmetry's inverse, which is its transpose.
  template <class V>
  V Undo(const V& p) const
  {
    V q;
    for (int n = 0; n < 3; ++n)
    {
      q[this->Axes[n]] = static_cast<typename V::value_type>(this->Signs[n]) * p[n];
    }
    return q;
  }
};

inline std::vector<CubeSymmetry> MakeCubeSymmetries()
{
  std::vector<CubeSymmetry> all;
  int axes[3] = { 0, 1, 2 };
  do
  {
    for (int n = 0; n < 8; ++n)
    {
      all.push_back(
        { { axes[0], axes[1], axes[2] }, { n & 1 ? -1 : 1, n & 2 ? -1 : 1, n & 4 ? -1 : 1 } });
    }
  } while (std::next_permutation(axes, axes + 3));
  return all;
}

} // namespace bravais

#endif
