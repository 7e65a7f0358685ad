// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FindRoot_h
#define FindRoot_h

#include <algorithm>
#include <cmath>

namespace bravais
{

/// A root of a continuous function on [0, 1] that has the values f0 and f1, of opposite signs, at
/// the ends, by the Illinois variant of regula falsi (Dowell and Jarratt, A Modified Regula Falsi
/// Method for Computing the Root of an Equation): superlinear, and the root stays enclosed. It ends
/// where the function is below 1e-6, or after 16 evaluations.
///
/// The twin of FindRoot in Rendering/GLSL, where the function is BCCDifference.
template <class T, class Function>
T FindRoot(const Function& function, T f0, T f1)
{
  T s0(0);
  T s1(1);
  T s(1);
  T kept(0); // the end that the last evaluation kept, -1 or 1
  for (int i = 0; i < 16; ++i)
  {
    s = std::clamp((s0 * f1 - s1 * f0) / (f1 - f0), s0, s1);
    const T f = function(s);
    if (std::abs(f) < T(1e-6))
    {
      break;
    }
    const bool first = f * f1 > T(0); // the root is in s0 .. s
    // An end that is kept twice counts half.
    f0 = first ? (kept < T(0) ? T(0.5) * f0 : f0) : f;
    f1 = first ? f : (kept > T(0) ? T(0.5) * f1 : f1);
    s0 = first ? s0 : s;
    s1 = first ? s : s1;
    kept = first ? T(-1) : T(1);
  }
  return s;
}

} // namespace bravais

#endif
