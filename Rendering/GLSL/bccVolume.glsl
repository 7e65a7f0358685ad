// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point of VTK's ray lies on the lattice, and which texel holds a lattice point's
// coefficient (vtkBCCVolumeFrame, vtkBCCCoefficientTexels). A texel is told by its place in a 3D
// texture, or by its number in a buffer.

uniform vec3 in_bccLow; // the volume's box in lattice coordinates
uniform vec3 in_bccHigh;
uniform int in_bccCosetDepth;      // slices of one coset
uniform int in_bccOriginTexel[3];  // of the lattice point 0: the halo, or before a piece's texels

// Lattice coordinates of texture coordinates. They are kept in the box: the halo ends beyond.
vec3 BCCPosition(vec3 texturePosition)
{
  return mix(in_bccLow, in_bccHigh, clamp(texturePosition, 0.0, 1.0));
}

#ifdef BCC_BUFFER
#define BCC_TEXEL int
uniform samplerBuffer in_bccCoefficients;
uniform ivec2 in_bccPitch; // texels of a row and of a slice

int BCCTexel(ivec3 v)
{
  return v.x + v.y * in_bccPitch.x + v.z * in_bccPitch.y;
}

BCC_VALUE BCCCoefficient(int texel)
{
  return BCC_VALUE(texelFetch(in_bccCoefficients, texel).BCC_CHANNELS);
}
#else
#define BCC_TEXEL ivec3
#define BCCTexel(v) (v)

BCC_VALUE BCCCoefficient(ivec3 texel)
{
  return BCC_VALUE(texelFetch(BCC_VOLUME, texel, 0).BCC_CHANNELS);
}
#endif

// The texel of the even lattice point 0, and of the odd one that is 1 along each axis.
ivec3 BCCEvenOrigin()
{
  return ivec3(in_bccOriginTexel[0], in_bccOriginTexel[1], in_bccOriginTexel[2]);
}

ivec3 BCCOddOrigin()
{
  return BCCEvenOrigin() + ivec3(0, 0, in_bccCosetDepth);
}

BCC_TEXEL BCCEvenTexel(ivec3 point)
{
  return BCCTexel((point >> 1) + BCCEvenOrigin());
}

BCC_TEXEL BCCOddTexel(ivec3 point)
{
  return BCCTexel((point >> 1) + BCCOddOrigin());
}
