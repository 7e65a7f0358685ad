// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point of VTK's ray lies on the lattice, and which texel holds a lattice point's
// coefficient (vtkBCCVolumeFrame, vtkBCCCoefficientTexels). A texel is told by its place in a 3D
// texture, or by its number in a buffer.

// Uniforms that each sample needs are copied as the ray starts, here and in later files: Mesa's
// software renderer reads a uniform wherever it is named, by 25 instructions a number. They are
// copied from elements of arrays, as its compiler undoes copies of whole variables.
uniform vec3 in_bccBox[2];        // the volume's low corner in lattice coordinates, and its size
uniform int in_bccOriginTexel[3]; // of the lattice point 0: the halo, or before a piece's texels
vec3 g_bccLow = in_bccBox[0];
vec3 g_bccBoxSize = in_bccBox[1];
ivec3 g_bccOriginTexel = ivec3(in_bccOriginTexel[0], in_bccOriginTexel[1], in_bccOriginTexel[2]);

// Lattice coordinates of texture coordinates. They are kept in the box: the halo ends beyond.
vec3 BCCPosition(vec3 texturePosition)
{
  return g_bccLow + clamp(texturePosition, 0.0, 1.0) * g_bccBoxSize;
}

// A step along an axis from a texel to the next of its coset, and a step from the texel of the even
// point 2 i to that of the odd point 2 i + 1.
#ifdef BCC_BUFFER
#define BCC_TEXEL int
uniform samplerBuffer in_bccCoefficients;
uniform int in_bccTexelSteps[4]; // along each axis, and to the odd point
ivec3 g_bccTexelSteps = ivec3(in_bccTexelSteps[0], in_bccTexelSteps[1], in_bccTexelSteps[2]);
int g_bccTexelToOdd = in_bccTexelSteps[3];

#define BCCTexelStep(axis) g_bccTexelSteps[axis]
#define BCCTexelToOdd() g_bccTexelToOdd

int BCCTexel(ivec3 v)
{
  return v.x * g_bccTexelSteps[0] + v.y * g_bccTexelSteps[1] + v.z * g_bccTexelSteps[2];
}

BCC_VALUE BCCCoefficient(int texel)
{
  return BCC_VALUE(texelFetch(in_bccCoefficients, texel).BCC_CHANNELS);
}
#else
#define BCC_TEXEL ivec3
uniform int in_bccCosetDepth; // slices of one coset

#define BCCTexelStep(axis) ivec3(equal(ivec3(axis), ivec3(0, 1, 2)))
#define BCCTexelToOdd() ivec3(0, 0, in_bccCosetDepth)
#define BCCTexel(v) (v)

BCC_VALUE BCCCoefficient(ivec3 texel)
{
  return BCC_VALUE(texelFetch(BCC_VOLUME, texel, 0).BCC_CHANNELS);
}
#endif

// The texel of the even lattice point 2 i.
BCC_TEXEL BCCEvenTexel(ivec3 i)
{
  return BCCTexel(i + g_bccOriginTexel);
}
