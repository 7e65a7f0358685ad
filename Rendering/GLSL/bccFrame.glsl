// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How a point's tetrahedron lies, for bcc4, bcc7 and bcc8 (Kim and Lee, Real-time BCC Volume
// Isosurface Ray Casting on the GPU, equations 18 to 26). The twin is in Module/Core/BoxSpline.h.

struct BCCFrame
{
  ivec3 Even;     // the even lattice point that is the tetrahedron's vertex (0, 0, 0)
  ivec3 Odd;      // the odd lattice point that is its vertex (1, 1, 1)
  ivec3 Steps[3]; // unit steps along the tetrahedron's axes: the rows of P_t R_p
  vec3 Point;     // the point in the reference tetrahedron 1 >= x >= y >= z >= 0
};

// Ranks take the place of the paper's six-way choice: each coordinate has its rank, 0 for the
// largest, and equal ones are ranked in the order x, y, z.
BCCFrame FindBCCFrame(vec3 p)
{
  BCCFrame frame;
  ivec3 low = ivec3(floor(p));
  ivec3 parity = low & 1;
  ivec3 sign = 1 - 2 * parity;
  frame.Even = low + parity;
  frame.Odd = frame.Even + sign;
  vec3 x = vec3(sign) * (p - vec3(frame.Even));
  ivec3 after = ivec3(greaterThan(x.yzz, x.xxy)); // y > x, z > x, z > y
  ivec3 rank = ivec3(after.x + after.y, 1 - after.x + after.z, 2 - after.y - after.z);
  frame.Steps[0] = sign * ivec3(equal(rank, ivec3(0)));
  frame.Steps[1] = sign * ivec3(equal(rank, ivec3(1)));
  frame.Steps[2] = sign * ivec3(equal(rank, ivec3(2)));
  float high = max(x.x, x.y);
  float other = min(x.x, x.y);
  frame.Point = vec3(max(high, x.z), max(other, min(high, x.z)), min(other, x.z));
  return frame;
}
