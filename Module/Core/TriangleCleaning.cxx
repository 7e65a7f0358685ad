// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleCleaning.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace bravais
{

//------------------------------------------------------------------------------
void MergeCoincidentPoints(const std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles)
{
  const auto key = [&](int n)
  {
    const glm::dvec3& p = points[static_cast<std::size_t>(n)];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<int> sorted(points.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(),
    [&](int a, int b)
    { return std::tuple_cat(key(a), std::tuple(a)) < std::tuple_cat(key(b), std::tuple(b)); });
  std::vector<int> first(points.size());
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    const bool same = n > 0 && key(sorted[n]) == key(sorted[n - 1]);
    first[static_cast<std::size_t>(sorted[n])] =
      same ? first[static_cast<std::size_t>(sorted[n - 1])] : sorted[n];
  }
  for (Triangle& triangle : triangles)
  {
    for (int& corner : triangle)
    {
      corner = first[static_cast<std::size_t>(corner)];
    }
  }
}

//------------------------------------------------------------------------------
void RemoveRepeatedTriangles(std::vector<Triangle>& triangles)
{
  std::vector<std::pair<Triangle, std::size_t>> sorted;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    Triangle t = triangles[n];
    std::sort(t.begin(), t.end());
    if (t[0] != t[1] && t[1] != t[2])
    {
      sorted.emplace_back(t, n);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    if (n == 0 || sorted[n].first != sorted[n - 1].first)
    {
      kept.push_back(sorted[n].second);
    }
  }
  std::sort(kept.begin(), kept.end());
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    triangles[n] = triangles[kept[n]];
  }
  triangles.resize(kept.size());
}

} // namespace bravais
