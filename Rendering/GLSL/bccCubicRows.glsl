// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The spline of bcc12: half the sum of the tri-cubic B-splines on the two cosets, each from sixteen
// rows of four coefficients that are fetched one by one, or four at once with BCC_FOURS.

#ifdef BCC_FOURS
// The four coefficients from a number on.
vec4 BCCRow(int first)
{
  vec4 a = texelFetch(in_bccCoefficients, first >> 2);
  vec4 b = texelFetch(in_bccCoefficients, (first >> 2) + 1);
  bool two = (first & 2) != 0;
  a = two ? vec4(a.zw, b.xy) : a;
  b.x = two ? b.z : b.x;
  return (first & 1) != 0 ? vec4(a.yzw, b.x) : a;
}

#define BCC_ROW vec4
#define BCCWeigh(row, w) dot(row, w)
#else
struct BCC_ROW
{
  BCC_VALUE C[4];
};

BCC_ROW BCCRow(int first)
{
  BCC_ROW row;
  row.C[0] = BCCCoefficient(first);
  row.C[1] = BCCCoefficient(first + 1);
  row.C[2] = BCCCoefficient(first + 2);
  row.C[3] = BCCCoefficient(first + 3);
  return row;
}

BCC_VALUE BCCWeigh(BCC_ROW row, vec4 w)
{
  return row.C[0] * w.x + row.C[1] * w.y + row.C[2] * w.z + row.C[3] * w.w;
}
#endif

// Of a point in a coset, weights along each axis and their derivatives.
struct CubicWeightsAt
{
  vec4 X, Y, Z;
  vec4 DX, DY, DZ;
};

// A sum of coefficients and its derivatives.
struct CubicSum
{
  BCC_VALUE Value, X, Y, Z;
};

void AddCubicRow(int first, vec4 x, vec4 dx, float y, float dy, inout CubicSum sum)
{
  BCC_ROW row = BCCRow(first);
  BCC_VALUE value = BCCWeigh(row, x);
  sum.Value += y * value;
  sum.X += y * BCCWeigh(row, dx);
  sum.Y += dy * value;
}

void AddCubicLayer(int first, CubicWeightsAt w, float z, float dz, inout CubicSum sum)
{
  CubicSum layer = CubicSum(BCC_VALUE(0.0), BCC_VALUE(0.0), BCC_VALUE(0.0), BCC_VALUE(0.0));
  int row = g_bccTexelSteps[1];
  AddCubicRow(first, w.X, w.DX, w.Y.x, w.DY.x, layer);
  AddCubicRow(first + row, w.X, w.DX, w.Y.y, w.DY.y, layer);
  AddCubicRow(first + 2 * row, w.X, w.DX, w.Y.z, w.DY.z, layer);
  AddCubicRow(first + 3 * row, w.X, w.DX, w.Y.w, w.DY.w, layer);
  sum.Value += z * layer.Value;
  sum.X += z * layer.X;
  sum.Y += z * layer.Y;
  sum.Z += dz * layer.Value;
}

// Adds the part of one coset; q is in texels from the one numbered origin.
void AddCubicCoset(vec3 q, int origin, inout CubicSum sum)
{
  vec3 low = floor(q);
  vec3 t = q - low;
  CubicWeightsAt w = CubicWeightsAt(CubicWeights(t.x), CubicWeights(t.y), CubicWeights(t.z),
    CubicDerivativeWeights(t.x), CubicDerivativeWeights(t.y), CubicDerivativeWeights(t.z));
  int first = origin + BCCTexel(ivec3(low) - 1);
  int layer = g_bccTexelSteps[2];
  AddCubicLayer(first, w, w.Z.x, w.DZ.x, sum);
  AddCubicLayer(first + layer, w, w.Z.y, w.DZ.y, sum);
  AddCubicLayer(first + 2 * layer, w, w.Z.z, w.DZ.z, sum);
  AddCubicLayer(first + 3 * layer, w, w.Z.w, w.DZ.w, sum);
}

// The value at p in lattice coordinates, and the derivatives along their axes.
BCC_VALUE EvaluateBoxSpline(vec3 p, out BCC_VALUE gx, out BCC_VALUE gy, out BCC_VALUE gz)
{
  CubicSum sum = CubicSum(BCC_VALUE(0.0), BCC_VALUE(0.0), BCC_VALUE(0.0), BCC_VALUE(0.0));
  AddCubicCoset(0.5 * p, BCCEvenTexel(ivec3(0)), sum);
  AddCubicCoset(0.5 * (p - 1.0), BCCEvenTexel(ivec3(0)) + BCCTexelToOdd(), sum);
  gx = 0.25 * sum.X;
  gy = 0.25 * sum.Y;
  gz = 0.25 * sum.Z;
  return 0.5 * sum.Value;
}
