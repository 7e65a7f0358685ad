// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The spline of bcc12: half the sum of the tri-cubic B-splines on the two cosets, each from eight
// linearly filtered fetches (Sigg and Hadwiger, Fast Third-Order Texture Filtering).

// Two neighbours' weighted sum is one filtered fetch between them times the sum of their weights,
// which have one sign in all pairs here: (both sums, both places, in texels from the sample below).
vec4 CubicPairs(vec4 w)
{
  vec2 sums = w.xz + w.yw;
  return vec4(sums, vec2(-0.5, 1.5) + w.yw / sums);
}

BCC_VALUE BCCFiltered(float x, float y, float z)
{
  return BCC_VALUE(textureLod(BCC_VOLUME, vec3(x, y, z), 0.0).BCC_CHANNELS);
}

// The tensor product of the pairs along three axes, the places in texture coordinates.
BCC_VALUE SumCubicPairs(vec4 x, vec4 y, vec4 z)
{
  return z.x * (y.x * (x.x * BCCFiltered(x.z, y.z, z.z) + x.y * BCCFiltered(x.w, y.z, z.z)) +
      y.y * (x.x * BCCFiltered(x.z, y.w, z.z) + x.y * BCCFiltered(x.w, y.w, z.z))) +
    z.y * (y.x * (x.x * BCCFiltered(x.z, y.z, z.w) + x.y * BCCFiltered(x.w, y.z, z.w)) +
      y.y * (x.x * BCCFiltered(x.z, y.w, z.w) + x.y * BCCFiltered(x.w, y.w, z.w)));
}

vec4 ToTexture(vec4 pairs, float base, float size)
{
  return vec4(pairs.xy, (pairs.zw + base) / size);
}

// Adds the part of one coset; q is in texels from the one at origin.
void AddCubicCoset(vec3 q, ivec3 origin, inout BCC_VALUE value, inout BCC_VALUE gx, inout BCC_VALUE gy,
  inout BCC_VALUE gz)
{
  vec3 size = vec3(textureSize(BCC_VOLUME, 0));
  vec3 low = floor(q);
  vec3 t = q - low;
  low += vec3(origin);
  vec4 x = ToTexture(CubicPairs(CubicWeights(t.x)), low.x, size.x);
  vec4 y = ToTexture(CubicPairs(CubicWeights(t.y)), low.y, size.y);
  vec4 z = ToTexture(CubicPairs(CubicWeights(t.z)), low.z, size.z);
  value += SumCubicPairs(x, y, z);
  gx += SumCubicPairs(ToTexture(CubicPairs(CubicDerivativeWeights(t.x)), low.x, size.x), y, z);
  gy += SumCubicPairs(x, ToTexture(CubicPairs(CubicDerivativeWeights(t.y)), low.y, size.y), z);
  gz += SumCubicPairs(x, y, ToTexture(CubicPairs(CubicDerivativeWeights(t.z)), low.z, size.z));
}

// The value at p in lattice coordinates, and the derivatives along their axes.
BCC_VALUE EvaluateBoxSpline(vec3 p, out BCC_VALUE gx, out BCC_VALUE gy, out BCC_VALUE gz)
{
  BCC_VALUE value = BCC_VALUE(0.0);
  gx = gy = gz = BCC_VALUE(0.0);
  AddCubicCoset(0.5 * p, BCCEvenTexel(ivec3(0)), value, gx, gy, gz);
  AddCubicCoset(0.5 * (p - 1.0), BCCEvenTexel(ivec3(0)) + BCCTexelToOdd(), value, gx, gy, gz);
  gx *= 0.25;
  gy *= 0.25;
  gz *= 0.25;
  return 0.5 * value;
}
