// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point of VTK's ray lies on the lattice, and which texel holds a lattice point's
// coefficient (vtkBCCVolumeFrame, vtkBCCCoefficientTexels).

uniform vec3 in_bccLow; // the volume's box in lattice coordinates
uniform vec3 in_bccHigh;
uniform int in_bccCosetDepth;      // slices of one coset

const int BCCHalo = 2;

// Lattice coordinates of texture coordinates. They are kept in the box: the halo ends beyond.
vec3 BCCPosition(vec3 texturePosition)
{
  return mix(in_bccLow, in_bccHigh, clamp(texturePosition, 0.0, 1.0));
}

ivec3 BCCEvenTexel(ivec3 point)
{
  return (point >> 1) + BCCHalo;
}

ivec3 BCCOddTexel(ivec3 point)
{
  return (point >> 1) + ivec3(BCCHalo, BCCHalo, BCCHalo + in_bccCosetDepth);
}

BCC_VALUE BCCCoefficient(ivec3 texel)
{
  return BCC_VALUE(texelFetch(BCC_VOLUME, texel, 0).BCC_CHANNELS);
}
