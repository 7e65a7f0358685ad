// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RoundTo_h
#define RoundTo_h

#include <cmath>
#include <limits>
#include <type_traits>

namespace bravais
{

/// A computed value as an array's type: floating-point types are converted, integers rounded to the
/// nearest and clamped to their range; not-a-number becomes the integer 0.
template <class T, class R>
inline T RoundTo(R value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return static_cast<T>(value);
  }
  else
  {
    // The range's ends as R: the upper one may be rounded up, to one more than the largest T.
    constexpr R low = static_cast<R>(std::numeric_limits<T>::lowest());
    constexpr R high = static_cast<R>(std::numeric_limits<T>::max());
    // Not floor(value + 1/2): that sum is rounded as well, wrongly for large odd numbers.
    const R below = std::floor(value);
    const R rounded = value - below < R(0.5) ? below : below + R(1);
    if (!(rounded > low))
    {
      return std::isnan(value) ? T(0) : std::numeric_limits<T>::lowest();
    }
    return rounded >= high ? std::numeric_limits<T>::max() : static_cast<T>(rounded);
  }
}

} // namespace bravais

#endif
