// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FoldedSquare_h
#define FoldedSquare_h

/// \file
/// A rectangle whose four edges are each folded on themselves about their middle is a closed
/// surface, a pillow, flat but for the four middles, where the angle is pi. Unfolded, it covers the
/// plane by half turns about the middles and by translations.

#include <glm/vec2.hpp>

#include <array>

namespace bravais
{

/// u -> Sign u + Shift.
struct HalfTurn
{
  double Sign = 1.0;
  glm::dvec2 Shift{ 0.0 };

  glm::dvec2 operator()(const glm::dvec2& u) const { return this->Sign * u + this->Shift; }
  /// This one after the other.
  HalfTurn operator*(const HalfTurn& other) const
  {
    return { this->Sign * other.Sign, this->Sign * other.Shift + this->Shift };
  }
  HalfTurn Invert() const { return { this->Sign, -this->Sign * this->Shift }; }
};

inline HalfTurn GetHalfTurn(const glm::dvec2& middle)
{
  return { -1.0, 2.0 * middle };
}

/// Middles of the edges of the rectangle from (0, 0) to `size`, anticlockwise from the lower one.
inline std::array<glm::dvec2, 4> GetFolds(const glm::dvec2& size)
{
  const glm::dvec2 half = 0.5 * size;
  return { { { half.x, 0.0 }, { size.x, half.y }, { half.x, size.y }, { 0.0, half.y } } };
}

} // namespace bravais

#endif
