// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The spline of a kernel with a reference tetrahedron: BCC_STENCIL is its stencil's size, BCC_FETCH
// and BCC_POLYNOMIAL are its functions of bccNPolynomial.glsl.

void FetchInFrame(BCCFrame frame, out BCC_VALUE c[BCC_STENCIL])
{
  BCC_FETCH(BCCEvenTexel(frame.Even), BCCOddTexel(frame.Odd), BCCTexel(frame.Steps[0]),
    BCCTexel(frame.Steps[1]), BCCTexel(frame.Steps[2]), c);
}

// The value at a frame's point, and the derivatives along the axes of the lattice coordinates.
BCC_VALUE EvaluateInFrame(BCCFrame frame, BCC_VALUE c[BCC_STENCIL], out BCC_VALUE gx,
  out BCC_VALUE gy, out BCC_VALUE gz)
{
  BCC_VALUE g0, g1, g2;
  BCC_VALUE value = BCC_POLYNOMIAL(frame.Point.x, frame.Point.y, frame.Point.z, c, g0, g1, g2);
  // The inverse of P_t R_p (eq. 26).
  mat3 back = mat3(vec3(frame.Steps[0]), vec3(frame.Steps[1]), vec3(frame.Steps[2]));
  gx = g0 * back[0].x + g1 * back[1].x + g2 * back[2].x;
  gy = g0 * back[0].y + g1 * back[1].y + g2 * back[2].y;
  gz = g0 * back[0].z + g1 * back[1].z + g2 * back[2].z;
  return value;
}

// The same at p in lattice coordinates.
BCC_VALUE EvaluateBoxSpline(vec3 p, out BCC_VALUE gx, out BCC_VALUE gy, out BCC_VALUE gz)
{
  BCCFrame frame = FindBCCFrame(p);
  BCC_VALUE c[BCC_STENCIL];
  FetchInFrame(frame, c);
  return EvaluateInFrame(frame, c, gx, gy, gz);
}
