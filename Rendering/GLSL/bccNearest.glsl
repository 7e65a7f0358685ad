// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The indices of the lattice point nearest to p, both in lattice coordinates, in a box from low to
// high: the nearest one of the even coset or of the odd. Distances are those of a system in which
// lattice coordinates have these derivatives.
ivec3 BCCNearest(vec3 p, vec3 low, vec3 high, vec3 perUnit)
{
  vec3 oddLow = mod(low, 2.0);
  vec3 oddHigh = mod(high, 2.0);
  vec3 even = clamp(2.0 * floor(0.5 * p + 0.5), low + oddLow, high - oddHigh);
  vec3 odd = clamp(2.0 * floor(0.5 * p) + 1.0, low + 1.0 - oddLow, high - 1.0 + oddHigh);
  bool first = length((p - even) / perUnit) <= length((p - odd) / perUnit);
  ivec3 point = ivec3(first ? even : odd);
  return ivec3((point.xy - ivec2(low.xy)) >> 1, point.z - int(low.z));
}
