// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// What a hardware selection is told: the sample nearest to what is seen, whose index takes the place
// of a cell's.

uniform vec3 in_bccLatticePerUnit; // derivatives of lattice coordinates
uniform vec3 in_bccHeldLow;        // the box of the samples, all of the volume's or a piece's
uniform vec3 in_bccHeldHigh;

uvec3 BCCPickedCounts()
{
  vec3 size = in_bccHeldHigh - in_bccHeldLow + 1.0;
  return uvec3(0.5 * size.xy, size.z);
}

uvec3 BCCPicked(vec3 texturePosition)
{
  return uvec3(
    BCCNearest(BCCPosition(texturePosition), in_bccHeldLow, in_bccHeldHigh, in_bccLatticePerUnit));
}

// The colour that selections of points read 24 bits of an index from, those after the shift.
vec4 BCCPickedColor(vec3 texturePosition, uint shift)
{
  uvec3 counts = BCCPickedCounts();
  uvec3 point = BCCPicked(texturePosition);
  uint index = ((point.z * counts.y + point.y) * counts.x + point.x) >> shift;
  return vec4(vec3(index & 255u, (index >> 8u) & 255u, (index >> 16u) & 255u) / 255.0, 1.0);
}
