// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point of VTK's ray lies on the lattice, and which texel holds a lattice point's
// coefficient (vtkBCCVolumeFrame, vtkBCCCoefficientTexels). A texel is told by its place in a 3D
// texture, or by its number in a buffer.

uniform vec3 in_bccLow; // the volume's box in lattice coordinates
uniform vec3 in_bccHigh;
uniform int in_bccCosetDepth;      // slices of one coset

const int BCCHalo = 2;

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

BCC_TEXEL BCCEvenTexel(ivec3 point)
{
  return BCCTexel((point >> 1) + BCCHalo);
}

BCC_TEXEL BCCOddTexel(ivec3 point)
{
  return BCCTexel((point >> 1) + ivec3(BCCHalo, BCCHalo, BCCHalo + in_bccCosetDepth));
}
