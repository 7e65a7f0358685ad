// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Labels of a mask: see vtkBCCVolumeMask.

// From texture coordinates of the volume to those of the mask, or to lattice coordinates of it.
uniform mat4 in_bccMaskMatrix;

#ifdef BCC_LATTICE_MASK
uniform vec3 in_bccMaskLow; // the mask's box in lattice coordinates
uniform vec3 in_bccMaskHigh;
uniform vec3 in_bccMaskPerUnit; // derivatives of lattice coordinates

// In the place of texture3D(in_mask, texturePosition).
vec4 BCCMask(vec3 texturePosition)
{
  vec3 p = (in_bccMaskMatrix * vec4(texturePosition, 1.0)).xyz;
  return texelFetch(
    in_mask, BCCNearest(p, in_bccMaskLow, in_bccMaskHigh, in_bccMaskPerUnit), 0);
}
#else
vec4 BCCMask(vec3 texturePosition)
{
  return texture(in_mask, (in_bccMaskMatrix * vec4(texturePosition, 1.0)).xyz);
}
#endif
