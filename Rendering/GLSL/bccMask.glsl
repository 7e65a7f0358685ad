// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Labels of a mask: see vtkBCCVolumeMask.

// From texture coordinates of the volume to those of the mask, or to lattice coordinates of it.
uniform mat4 in_bccMaskMatrix;
uniform vec3 in_bccMaskMargin; // by which the mask's box is exceeded before there are no labels

bool BCCIsMasked(vec3 p, vec3 low, vec3 high)
{
  return all(lessThanEqual(low - in_bccMaskMargin, p)) &&
    all(lessThanEqual(p, high + in_bccMaskMargin));
}

#ifdef BCC_LATTICE_MASK
uniform vec3 in_bccMaskLow; // the mask's box in lattice coordinates
uniform vec3 in_bccMaskHigh;
uniform vec3 in_bccMaskPerUnit; // derivatives of lattice coordinates

// In the place of texture3D(in_mask, texturePosition).
vec4 BCCMask(vec3 texturePosition)
{
  vec3 p = (in_bccMaskMatrix * vec4(texturePosition, 1.0)).xyz;
  ivec3 point = BCCNearest(p, in_bccMaskLow, in_bccMaskHigh, in_bccMaskPerUnit);
  return BCCIsMasked(p, in_bccMaskLow, in_bccMaskHigh) ? texelFetch(in_mask, point, 0) : vec4(0.0);
}
#else
vec4 BCCMask(vec3 texturePosition)
{
  vec3 p = (in_bccMaskMatrix * vec4(texturePosition, 1.0)).xyz;
  return BCCIsMasked(p, vec3(0.0), vec3(1.0)) ? texture(in_mask, p) : vec4(0.0);
}
#endif

#ifdef BCC_LABELS
uniform float in_bccLabelFactor; // makes labels of texels

// The label as VTK takes it to look up functions: a fraction of the largest that has functions of its
// own, between this one and the next. Labels that have none are 0, as is what has no label.
float BCCLabel(float texel)
{
  float label = floor(in_bccLabelFactor * texel + 0.25);
  float count = float(in_labelMapNumLabels);
  return label > 0.0 && label <= count ? (label + 0.5) / count : 0.0;
}
#endif
