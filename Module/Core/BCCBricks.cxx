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

bool Contains(const Range& range, int coordinate)
{
  return range.First <= coordinate && coordinate <= range.Last;
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
int BCCBricks::GetNearReach(BCCKernel kernel)
{
  return kernel == BCCKernel::BCC12 ? 3 : 2;
}

//------------------------------------------------------------------------------
float BCCBricks::GetFarWeight(BCCKernel kernel)
{
  // Of each axis, at a face of the brick: what the planes have that are 2 away or more, for
  // bcc12 3. Only on bcc8's it depends on the place in the plane.
  switch (kernel)
  {
    case BCCKernel::BCC4:
      break;
    case BCCKernel::BCC7:
      return 3.0f / 48.0f;
    case BCCKernel::BCC8:
      return 3.0f / 32.0f;
    case BCCKernel::BCC12:
      return 3.0f / 96.0f;
  }
  return 0.0f;
}

/// Of either parity, the rows near a line of bricks and the others.
struct BCCBricks::Rows
{
  explicit Rows(std::size_t size)
    : Near{ Row(size), Row(size) }
    , Far{ Row(size), Row(size) }
  {
  }

  void Clear()
  {
    for (const int parity : { 0, 1 })
    {
      this->Near[parity].Clear();
      this->Far[parity].Clear();
    }
  }

  Row Near[2];
  Row Far[2];
};

//------------------------------------------------------------------------------
void BCCBricks::ComputeLayer(BCCKernel kernel, const BCCTexels& texels, int layer)
{
  const int reach = GetReach(kernel);
  const int nearReach = GetNearReach(kernel);
  Rows rows(static_cast<std::size_t>(texels.Size.x) * static_cast<std::size_t>(texels.Components));
  const Range layers = GetPlanes(layer, this->FirstLayer, this->Last.z, reach);
  const Range nearLayers = GetPlanes(layer, this->FirstLayer, this->Last.z, nearReach);
  for (int b = 0; b < this->Size.y; ++b)
  {
    const Range all = GetPlanes(b, 0, this->Last.y, reach);
    const Range near = GetPlanes(b, 0, this->Last.y, nearReach);
    rows.Clear();
    for (int Z = layers.First; Z <= layers.Last; ++Z)
    {
      const Range some = Restrict(all, Z & 1);
      for (int Y = some.First; Y <= some.Last; Y += 2)
      {
        Row* to = Contains(nearLayers, Z) && Contains(near, Y) ? rows.Near : rows.Far;
        to[Z & 1].Add(texels.GetRow(Y, Z));
      }
    }
    const std::size_t brick = static_cast<std::size_t>(this->Size.x) *
      (static_cast<std::size_t>(this->Size.y) * static_cast<std::size_t>(layer) +
        static_cast<std::size_t>(b));
    this->ReduceRow(rows, kernel, brick);
  }
}

//------------------------------------------------------------------------------
void BCCBricks::ReduceRow(const Rows& rows, BCCKernel kernel, std::size_t brick)
{
  const auto components = static_cast<std::size_t>(this->Components);
  const float weight = GetFarWeight(kernel);
  for (int a = 0; a < this->Size.x; ++a, ++brick)
  {
    const Range all = GetPlanes(a, 0, this->Last.x, GetReach(kernel));
    const Range near = GetPlanes(a, 0, this->Last.x, GetNearReach(kernel));
    for (std::size_t c = 0; c < components; ++c)
    {
      float low[2] = { Infinity, Infinity }; // of the near ones, and of all
      float high[2] = { -Infinity, -Infinity };
      float zero = 0.0f;
      for (const int parity : { 0, 1 })
      {
        const Row& nearRow = rows.Near[parity];
        const Row& farRow = rows.Far[parity];
        const Range some = Restrict(all, parity);
        for (int X = some.First; X <= some.Last; X += 2)
        {
          const std::size_t n =
            static_cast<std::size_t>((X >> 1) + BCCTexels::Halo) * components + c;
          low[1] = std::min({ low[1], nearRow.Low[n], farRow.Low[n] });
          high[1] = std::max({ high[1], nearRow.High[n], farRow.High[n] });
          zero += nearRow.Zero[n] + farRow.Zero[n];
          if (Contains(near, X))
          {
            low[0] = std::min(low[0], nearRow.Low[n]);
            high[0] = std::max(high[0], nearRow.High[n]);
          }
        }
      }
      const bool finite = zero == 0.0f;
      this->Low[brick * components + c] = finite ? low[0] + weight * (low[1] - low[0]) : -Infinity;
      this->High[brick * components + c] =
        finite ? high[0] + weight * (high[1] - high[0]) : Infinity;
    }
  }
}

} // namespace bravais
