// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How a point's tetrahedron lies, for bcc4, bcc7 and bcc8 (Kim and Lee, Real-time BCC Volume
// Isosurface Ray Casting on the GPU, equations 18 to 26). The twin is in Module/Core/BoxSpline.h.

struct BCCFrame
{
  BCC_TEXEL Even;  // of the even lattice point that is the tetrahedron's vertex (0, 0, 0)
  BCC_TEXEL Odd;   // of the odd lattice point that is its vertex (1, 1, 1)
  BCC_TEXEL Step0; // steps of 2 along the tetrahedron's axes: the rows of P_t R_p
  BCC_TEXEL Step1;
  BCC_TEXEL Step2;
  vec3 Point;      // the point in the reference tetrahedron 1 >= x >= y >= z >= 0
  bvec3 Mirrored;  // which axes run back (R_p)
  bvec3 Swapped;   // whether first and second, second and third, first and second axis were
                   // exchanged in turn (P_t)
};

// Puts two axes in the order of their coordinates, the larger first.
bool BCCSort(inout float x, inout float y, inout BCC_TEXEL stepX, inout BCC_TEXEL stepY)
{
  bool swap = y > x;
  float first = x;
  x = swap ? y : x;
  y = swap ? first : y;
  BCC_TEXEL firstStep = stepX;
  stepX = swap ? stepY : stepX;
  stepY = swap ? firstStep : stepY;
  return swap;
}

// The paper's choice of one of eight and one of six is made axis by axis, and by sorting: nothing
// here is a branch, nor looks anything up.
BCCFrame FindBCCFrame(vec3 p)
{
  BCCFrame frame;
  vec3 nearest = floor(0.5 * p + 0.5); // Twice that is the even point.
  vec3 way = p - 2.0 * nearest;
  frame.Mirrored = lessThan(way, vec3(0.0));
  frame.Point = abs(way);
  BCC_TEXEL zero = BCC_TEXEL(0);
  BCC_TEXEL back0 = frame.Mirrored.x ? BCCTexelStep(0) : zero;
  BCC_TEXEL back1 = frame.Mirrored.y ? BCCTexelStep(1) : zero;
  BCC_TEXEL back2 = frame.Mirrored.z ? BCCTexelStep(2) : zero;
  frame.Even = BCCEvenTexel(ivec3(nearest));
  frame.Odd = frame.Even + BCCTexelToOdd() - back0 - back1 - back2;
  frame.Step0 = BCCTexelStep(0) - 2 * back0;
  frame.Step1 = BCCTexelStep(1) - 2 * back1;
  frame.Step2 = BCCTexelStep(2) - 2 * back2;
  frame.Swapped.x = BCCSort(frame.Point.x, frame.Point.y, frame.Step0, frame.Step1);
  frame.Swapped.y = BCCSort(frame.Point.y, frame.Point.z, frame.Step1, frame.Step2);
  frame.Swapped.z = BCCSort(frame.Point.x, frame.Point.y, frame.Step0, frame.Step1);
  return frame;
}
