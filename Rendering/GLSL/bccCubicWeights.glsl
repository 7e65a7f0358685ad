// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The uniform cubic B-spline, of which bcc12 is made.

// Weights of the uniform cubic B-spline for the coefficients at -1, 0, 1, 2, at 0 <= t <= 1.
vec4 CubicWeights(float t)
{
  float s = 1.0 - t;
  return vec4(s * s * s, 4.0 + t * t * (3.0 * t - 6.0), 4.0 + s * s * (3.0 * s - 6.0), t * t * t) /
    6.0;
}

// The derivatives of CubicWeights.
vec4 CubicDerivativeWeights(float t)
{
  float s = 1.0 - t;
  return 0.5 * vec4(-s * s, t * (3.0 * t - 4.0), -(s * (3.0 * s - 4.0)), t * t);
}
