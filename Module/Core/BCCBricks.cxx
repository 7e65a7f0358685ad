// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCBricks.h"

#include <algorithm>
#include <limits>

namespace bravais
{
namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

/// A range of integer coordinates.
struct Range
{
  int First;
  int Last;
};

/// The coordinates of lattice planes that matter to a brick of one axis: those less than `reach`
/// away from it.
Range GetPlanes(int brick, int first, int last, int reach)
{
  const int low = std::max(brick * BCCBricks::Edge, first);
  const int high = std::min((brick + 1) * BCCBricks::Edge, last);
  return { low - reach + 1, high + reach - 1 };
}

/// Of a range, the coordinates of a parity.
Range Restrict(const Range& range, int parity)
{
  return { range.First + ((range.First ^ parity) & 1), range.Last - ((range.Last ^ parity) & 1) };
}

} // namespace

/// Bounds over rows of texels, and what is 0 where all these are finite.
struct BCCBricks::Row
{
  explicit Row(std::size_t size)
    : Low(size)
    , High(size)
    , Zero(size)
  {
  }

  void Clear()
  {
    std::fill(this->Low.begin(), this->Low.end(), Infinity);
    std::fill(this->High.begin(), this->High.end(), -Infinity);
    std::fill(this->Zero.begin(), this->Zero.end(), 0.0f);
  }

  void Add(const float* values)
  {
    float* low = this->Low.data();
    float* high = this->High.data();
    float* zero = this->Zero.data();
    const std::size_t size = this->Low.size();
    for (std::size_t n = 0; n < size; ++n)
    {
      const float value = values[n];
      low[n] = value < low[n] ? value : low[n];
      high[n] = value > high[n] ? value : high[n];
      zero[n] += value * 0.0f;
    }
  }

  std::vector<float> Low;
  std::vector<float> High;
  std::vector<float> Zero;
};

//------------------------------------------------------------------------------
BCCBricks::BCCBricks(const glm::ivec3& last, int firstLayer, int components)
  : Last(last)
  , FirstLayer(firstLayer)
  , Components(components)
  , Size((last + (Edge - 1)) / Edge)
{
  const std::size_t count = static_cast<std::size_t>(this->Size.x) *
    static_cast<std::size_t>(this->Size.y) * static_cast<std::size_t>(this->Size.z) *
    static_cast<std::size_t>(components);
  this->Low.resize(count);
  this->High.resize(count);
}

//------------------------------------------------------------------------------
int BCCBricks::GetReach(BCCKernel kernel)
{
  // Half the sum of what the directions of each box-spline have along an axis.
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return 2;
    case BCCKernel::BCC7:
      return 3;
    case BCCKernel::BCC8:
    case BCCKernel::BCC12:
      break;
  }
  return 4;
}

//------------------------------------------------------------------------------
void BCCBricks::ComputeLayer(BCCKernel kernel, const BCCTexels& texels, int layer)
{
  const int reach = GetReach(kernel);
  const std::size_t size =
    static_cast<std::size_t>(texels.Size.x) * static_cast<std::size_t>(texels.Components);
  Row rows[2] = { Row(size), Row(size) };
  const Range layers = GetPlanes(layer, this->FirstLayer, this->Last.z, reach);
  for (int b = 0; b < this->Size.y; ++b)
  {
    const Range all = GetPlanes(b, 0, this->Last.y, reach);
    rows[0].Clear();
    rows[1].Clear();
    for (int Z = layers.First; Z <= layers.Last; ++Z)
    {
      const Range some = Restrict(all, Z & 1);
      for (int Y = some.First; Y <= some.Last; Y += 2)
      {
        rows[Z & 1].Add(texels.GetRow(Y, Z));
      }
    }
    const std::size_t brick = static_cast<std::size_t>(this->Size.x) *
      (static_cast<std::size_t>(this->Size.y) * static_cast<std::size_t>(layer) +
        static_cast<std::size_t>(b));
    this->ReduceRow(rows[0], rows[1], reach, brick);
  }
}

//------------------------------------------------------------------------------
void BCCBricks::ReduceRow(const Row& even, const Row& odd, int reach, std::size_t brick)
{
  const auto components = static_cast<std::size_t>(this->Components);
  for (int a = 0; a < this->Size.x; ++a, ++brick)
  {
    const Range all = GetPlanes(a, 0, this->Last.x, reach);
    for (std::size_t c = 0; c < components; ++c)
    {
      float low = Infinity;
      float high = -Infinity;
      float zero = 0.0f;
      for (const int parity : { 0, 1 })
      {
        const Row& row = parity == 0 ? even : odd;
        const Range some = Restrict(all, parity);
        for (int X = some.First; X <= some.Last; X += 2)
        {
          const std::size_t n =
            static_cast<std::size_t>((X >> 1) + BCCTexels::Halo) * components + c;
          low = std::min(low, row.Low[n]);
          high = std::max(high, row.High[n]);
          zero += row.Zero[n];
        }
      }
      const bool finite = zero == 0.0f;
      this->Low[brick * components + c] = finite ? low : -Infinity;
      this->High[brick * components + c] = finite ? high : Infinity;
    }
  }
}

} // namespace bravais
