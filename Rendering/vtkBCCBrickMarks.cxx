// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCBrickMarks.h"

#include "BCCBricks.h"
#include "BrickDistances.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{

// Bounds of one component, widened by more than float arithmetic can err.
struct Bounds
{
  Bounds(const bravais::BCCBricks& bricks, std::size_t brick, int component)
  {
    const std::size_t n = brick * bricks.GetComponents() + component;
    this->Low = bricks.GetLow()[n];
    this->High = bricks.GetHigh()[n];
    const double margin = 2e-5 * std::max(std::abs(this->Low), std::abs(this->High));
    if (std::isfinite(margin))
    {
      this->Low -= margin;
      this->High += margin;
    }
  }
  double Low;
  double High;
};

std::size_t GetCount(const bravais::BCCBricks& bricks)
{
  return bricks.GetLow().size() / bricks.GetComponents();
}

// A byte for every brick.
template <class Mark>
std::vector<std::uint8_t> MarkAll(const bravais::BCCBricks& bricks, const Mark& mark)
{
  std::vector<std::uint8_t> marks(GetCount(bricks));
  vtkSMPTools::For(0, static_cast<vtkIdType>(marks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        marks[brick] = mark(static_cast<std::size_t>(brick)) ? 1 : 0;
      }
    });
  return marks;
}

// How many of a table's first entries are seen, for each number of them.
std::vector<int> CountSeen(const std::vector<bool>& seen)
{
  std::vector<int> counts(seen.size() + 1);
  for (std::size_t n = 0; n < seen.size(); ++n)
  {
    counts[n + 1] = counts[n] + seen[n];
  }
  return counts;
}

// The scalar of a value, beyond 0 and 1 by no more than one.
double ToScalar(double value, const vtkBCCBrickMarks::Scalars& scalars)
{
  return std::clamp(value * scalars.Scale + scalars.Bias, -1.0, 2.0);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<std::uint8_t> vtkBCCBrickMarks::FindDistances(
  const bravais::BCCBricks& bricks, const std::vector<Scalars>& components)
{
  std::vector<std::vector<int>> counts;
  for (const Scalars& scalars : components)
  {
    counts.push_back(CountSeen(scalars.Seen));
  }
  const auto isSeen = [&](std::size_t brick)
  {
    for (std::size_t n = 0; n < components.size(); ++n)
    {
      const Bounds bounds(bricks, brick, components[n].Component);
      const double size = static_cast<double>(components[n].Seen.size());
      // Texture filtering blends the entries on either side; one more for what rounds otherwise.
      const double low = std::floor(ToScalar(bounds.Low, components[n]) * size - 0.5) - 1.0;
      const double high = std::ceil(ToScalar(bounds.High, components[n]) * size - 0.5) + 1.0;
      const auto first = static_cast<std::size_t>(std::clamp(low, 0.0, size - 1.0));
      const auto last = static_cast<std::size_t>(std::clamp(high, 0.0, size - 1.0));
      if (counts[n][last + 1] > counts[n][first])
      {
        return true;
      }
    }
    return false;
  };
  std::vector<std::uint8_t> marks = MarkAll(bricks, isSeen);
  bravais::FindSignedBrickDistances(bricks.GetSize(), marks);
  return marks;
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> vtkBCCBrickMarks::FindDistances(
  const bravais::BCCBricks& bricks, const std::vector<double>& values)
{
  const auto isMet = [&](std::size_t brick)
  {
    for (int component = 0; component < bricks.GetComponents(); ++component)
    {
      const Bounds bounds(bricks, brick, component);
      if (std::any_of(values.begin(), values.end(),
            [&](double value) { return bounds.Low <= value && value <= bounds.High; }))
      {
        return true;
      }
    }
    return false;
  };
  std::vector<std::uint8_t> marks = MarkAll(bricks, isMet);
  bravais::FindSignedBrickDistances(bricks.GetSize(), marks);
  return marks;
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> vtkBCCBrickMarks::FindBounds(
  const bravais::BCCBricks& bricks, const std::vector<Scalars>& components, bool upper)
{
  const std::size_t count = components.size();
  const std::size_t channels = count == 3 ? 4 : count;
  std::vector<std::uint8_t> bytes(GetCount(bricks) * channels);
  vtkSMPTools::For(0, static_cast<vtkIdType>(GetCount(bricks)),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        for (std::size_t n = 0; n < count; ++n)
        {
          const Bounds bounds(bricks, brick, components[n].Component);
          const double scalar = ToScalar(upper ? bounds.High : bounds.Low, components[n]) * 255.0;
          const double byte = upper ? std::ceil(scalar + 1e-3) : std::floor(scalar - 1e-3);
          bytes[brick * channels + n] = static_cast<std::uint8_t>(std::clamp(byte, 0.0, 255.0));
        }
      }
    });
  return bytes;
}
