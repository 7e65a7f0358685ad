// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// A root of BCCDifference(s) on [0, 1], where it has the values f0 and f1, of opposite signs, at
// the ends, by the Illinois variant of regula falsi. The twin is Module/Core/FindRoot.h.
float FindRoot(float f0, float f1)
{
  float s0 = 0.0;
  float s1 = 1.0;
  float s = 1.0;
  float kept = 0.0; // the end that the last evaluation kept, -1 or 1
  for (int i = 0; i < 16; ++i)
  {
    s = clamp((s0 * f1 - s1 * f0) / (f1 - f0), s0, s1);
    float f = BCCDifference(s);
    if (abs(f) < 1e-6)
    {
      break;
    }
    bool first = f * f1 > 0.0; // the root is in s0 .. s
    // An end that is kept twice counts half.
    f0 = first ? (kept < 0.0 ? 0.5 * f0 : f0) : f;
    f1 = first ? f : (kept > 0.0 ? 0.5 * f1 : f1);
    s0 = first ? s0 : s;
    s1 = first ? s : s1;
    kept = first ? -1.0 : 1.0;
  }
  return s;
}
