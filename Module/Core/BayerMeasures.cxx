// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerMeasures.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <complex>
#include <kissfft/kissfft.hh>

namespace bravais
{
namespace
{

using Complex = std::complex<double>;

struct Offset
{
  std::int64_t SquaredLength;
  glm::ivec3 Step;
};

/// All steps but zero to another cell of the torus, by the shortest way, the short ones first.
std::vector<Offset> GetOffsets(const BayerPattern& pattern)
{
  const int size = static_cast<int>(pattern.GetSize());
  const int first = -(size - 1) / 2;
  const int last = size / 2;
  const bool flat = pattern.GetDimension() == 2;
  std::vector<Offset> offsets;
  for (int z = flat ? 0 : first; z <= (flat ? 0 : last); ++z)
  {
    for (int y = first; y <= last; ++y)
    {
      for (int x = first; x <= last; ++x)
      {
        const std::int64_t squared =
          std::int64_t{ x } * x + std::int64_t{ y } * y + std::int64_t{ z } * z;
        if (squared > 0)
        {
          offsets.push_back({ squared, { x, y, z } });
        }
      }
    }
  }
  std::sort(offsets.begin(), offsets.end(),
    [](const Offset& a, const Offset& b) { return a.SquaredLength < b.SquaredLength; });
  return offsets;
}

/// Power of an array of the pattern's cells, by one-dimensional transforms along each axis.
std::vector<double> GetPower(const BayerPattern& pattern, const std::vector<double>& values)
{
  const std::size_t cells = values.size();
  const auto size = static_cast<std::size_t>(pattern.GetSize());
  const kissfft<double> transform(size, false);
  std::vector<Complex> spectrum(values.begin(), values.end());
  std::vector<Complex> line(size);
  std::vector<Complex> result(size);
  std::size_t step = 1;
  for (int axis = 0; axis < pattern.GetDimension(); ++axis, step *= size)
  {
    for (std::size_t start = 0; start < cells; ++start)
    {
      if ((start / step) % size != 0)
      {
        continue;
      }
      for (std::size_t n = 0; n < size; ++n)
      {
        line[n] = spectrum[start + n * step];
      }
      transform.transform(line.data(), result.data());
      for (std::size_t n = 0; n < size; ++n)
      {
        spectrum[start + n * step] = result[n];
      }
    }
  }
  std::vector<double> power(cells);
  std::transform(spectrum.begin(), spectrum.end(), power.begin(),
    [=](const Complex& v) { return std::norm(v) / static_cast<double>(cells); });
  return power;
}

} // namespace

std::vector<std::int64_t> GetSquaredMinimumDistances(const BayerPattern& pattern)
{
  const std::vector<Offset> offsets = GetOffsets(pattern);
  const int mask = static_cast<int>(pattern.GetSize() - 1);
  std::vector<char> taken(static_cast<std::size_t>(pattern.GetNumberOfCells()), 0);
  std::vector<std::int64_t> distances;
  distances.reserve(taken.size());
  std::int64_t smallest = pattern.GetSize() * pattern.GetSize();
  for (std::int64_t rank = 0; rank < pattern.GetNumberOfCells(); ++rank)
  {
    // The more cells, the shorter their distance: few offsets are looked at, O(n log n) in all.
    const glm::ivec3 cell = pattern.GetCell(rank);
    for (const Offset& offset : offsets)
    {
      if (offset.SquaredLength >= smallest)
      {
        break;
      }
      const glm::ivec3 other = (cell + offset.Step) & mask;
      if (taken[static_cast<std::size_t>(pattern.ToLinear(other))])
      {
        smallest = offset.SquaredLength;
      }
    }
    taken[static_cast<std::size_t>(pattern.ToLinear(cell))] = 1;
    distances.push_back(smallest);
  }
  return distances;
}

std::vector<double> GetThresholdSpectrum(const BayerPattern& pattern)
{
  const std::vector<std::int64_t> ranks = GetThresholds(pattern);
  const auto cells = static_cast<double>(ranks.size());
  std::vector<double> values(ranks.size());
  std::transform(ranks.begin(), ranks.end(), values.begin(),
    [=](std::int64_t rank) { return (static_cast<double>(rank) + 0.5) / cells - 0.5; });
  return GetPower(pattern, values);
}

std::vector<double> GetPrefixSpectrum(const BayerPattern& pattern, std::int64_t m)
{
  const std::vector<std::int64_t> ranks = GetThresholds(pattern);
  const double mean = static_cast<double>(m) / static_cast<double>(ranks.size());
  std::vector<double> values(ranks.size());
  std::transform(ranks.begin(), ranks.end(), values.begin(),
    [=](std::int64_t rank) { return (rank < m ? 1.0 : 0.0) - mean; });
  return GetPower(pattern, values);
}

} // namespace bravais
