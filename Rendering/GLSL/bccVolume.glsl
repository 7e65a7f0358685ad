// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point of VTK's ray lies on the lattice, and which texel holds a lattice point's
// coefficient (vtkBCCVolumeFrame, vtkBCCCoefficientTexels). A texel is told by its place in a 3D
// texture, or by its number in a buffer.

uniform vec3 in_bccLow; // the volume's box in lattice coordinates
uniform vec3 in_bccHigh;
uniform int in_bccOriginTexel[3];  // of the lattice point 0: the halo, or before a piece's texels

// Lattice coordinates of texture coordinates. They are kept in the box: the halo ends beyond.
vec3 BCCPosition(vec3 texturePosition)
{
  return mix(in_bccLow, in_bccHigh, clamp(texturePosition, 0.0, 1.0));
}

#ifdef BCC_BUFFER
#define BCC_TEXEL int
uniform samplerBuffer in_bccCoefficients;
uniform int in_bccTexelSteps[3]; // along each axis
uniform int in_bccTexelToOdd;    // from the even point of an index to the odd one

int BCCTexel(ivec3 v)
{
  return v.x * in_bccTexelSteps[0] + v.y * in_bccTexelSteps[1] + v.z * in_bccTexelSteps[2];
}

BCC_VALUE BCCCoefficient(int texel)
{
  return BCC_VALUE(texelFetch(in_bccCoefficients, texel).BCC_CHANNELS);
}
#else
#define BCC_TEXEL ivec3
#define BCCTexel(v) (v)
uniform int in_bccCosetDepth; // slices of one coset

BCC_VALUE BCCCoefficient(ivec3 texel)
{
  return BCC_VALUE(texelFetch(BCC_VOLUME, texel, 0).BCC_CHANNELS);
}
#endif

// The texels of an even lattice point, and of an odd one.
BCC_TEXEL BCCEvenTexel(ivec3 point)
{
  ivec3 origin = ivec3(in_bccOriginTexel[0], in_bccOriginTexel[1], in_bccOriginTexel[2]);
  return BCCTexel((point >> 1) + origin);
}

BCC_TEXEL BCCOddTexel(ivec3 point)
{
#ifdef BCC_BUFFER
  return BCCEvenTexel(point) + in_bccTexelToOdd;
#else
  return BCCEvenTexel(point) + ivec3(0, 0, in_bccCosetDepth);
#endif
}
