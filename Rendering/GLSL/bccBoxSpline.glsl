// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The spline of a kernel with a reference tetrahedron: BCC_STENCIL is its stencil's size, BCC_FETCH
// and BCC_POLYNOMIAL are its functions of bccNPolynomial.glsl.

void FetchInFrame(BCCFrame frame, out BCC_VALUE c[BCC_STENCIL])
{
  BCC_FETCH(frame.Even, frame.Odd, frame.Step0, frame.Step1, frame.Step2, c);
}

void BCCSwap(bool swap, inout BCC_VALUE a, inout BCC_VALUE b)
{
  BCC_VALUE first = a;
  a = swap ? b : first;
  b = swap ? first : b;
}

// The value at a frame's point, and the derivatives along the axes of the lattice coordinates: those
// along the tetrahedron's, turned by the inverse of P_t R_p (eq. 26).
BCC_VALUE EvaluateInFrame(BCCFrame frame, BCC_VALUE c[BCC_STENCIL], out BCC_VALUE gx,
  out BCC_VALUE gy, out BCC_VALUE gz)
{
  BCC_VALUE value = BCC_POLYNOMIAL(frame.Point.x, frame.Point.y, frame.Point.z, c, gx, gy, gz);
  BCCSwap(frame.Swapped.z, gx, gy);
  BCCSwap(frame.Swapped.y, gy, gz);
  BCCSwap(frame.Swapped.x, gx, gy);
  gx = frame.Mirrored.x ? -gx : gx;
  gy = frame.Mirrored.y ? -gy : gy;
  gz = frame.Mirrored.z ? -gz : gz;
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
