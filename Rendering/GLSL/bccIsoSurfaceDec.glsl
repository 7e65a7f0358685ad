// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces at the true roots of the spline along the ray: between two samples on either side of
// an isovalue the root is found, and shaded there.

uniform float in_bccDepthOpacity; // the opacity from which a surface counts for the depth

// The argument that VTK's functions take where components are independent.
#ifdef BCC_INDEPENDENT
#define BCC_COMPONENT_ARGUMENT , BCCIsoComponent()
#else
#define BCC_COMPONENT_ARGUMENT
#endif

vec3 l_bccPosition; // the last sample's
float l_bccScalar;
vec3 l_bccPositionBefore; // of the sample before the last, or the last where there is none
float l_bccScalarBefore;
vec3 l_bccStep; // from it to this one
vec2 l_bccIsoValues; // that the ray meets next when the scalar falls, and when it rises
float l_bccIsoValue;  // the one of them that it does meet
float l_bccSteps; // from the first sample to the ray's end
bool l_bccFirst;
bool l_bccLast;
bool l_bccWithin; // whether the sample before this one is in the same empty bricks
float g_bccDepth; // of the window
bool g_bccDepthTaken;
vec3 g_bccSurface; // where that is

// The component that has the largest weight.
int BCCIsoComponent()
{
  int component = 0;
#ifdef BCC_INDEPENDENT
  for (int i = 1; i < in_noOfComponents; ++i)
  {
    component = in_componentWeight[i] > in_componentWeight[component] ? i : component;
  }
#endif
  return component;
}

// The scalar in units of its range, from 0 to 1, within the sentinels of l_normValues; NaN is kept.
float BCCIsoScalar(vec3 texturePosition)
{
  vec4 scalars = BCCLookUp(texturePosition) * in_volume_scale[0] + in_volume_bias[0];
  float scalar = scalars[BCCIsoComponent()];
  return isnan(scalar) ? scalar : clamp(scalar, -1e19, 1e19);
}

// What FindRoot looks for: between the last sample and this one, where the scalar is the isovalue.
float BCCDifference(float s)
{
  return BCCIsoScalar(l_bccPosition + s * l_bccStep) - l_bccIsoValue;
}

// Whether cropping and a binary mask leave a point, and a piece has it.
bool BCCIsVisible(vec3 texturePosition)
{
  bool visible = true;
#ifdef BCC_PIECE
  visible = BCCIsOwned(texturePosition);
#endif
#ifdef BCC_CROPPING
  visible = visible && in_croppingFlags[BCCRegion(texturePosition)] != 0;
#endif
#ifdef BCC_BINARY_MASK
  visible = visible && BCCMask(texturePosition).r > 0.0;
#endif
  return visible;
}

// Enters the interval of l_normValues that has this number.
void BCCEnterInterval(int interval)
{
  l_initialIndex = clamp(interval, 0, NUMBER_OF_CONTOURS);
  l_bccIsoValues = vec2(l_normValues[l_initialIndex], l_normValues[l_initialIndex + 1]);
}

float BCCNextIsoValue(bool rising)
{
  return rising ? l_bccIsoValues.y : l_bccIsoValues.x;
}

// Makes a sample the last one.
void BCCPassSample(vec3 texturePosition, float scalar)
{
  l_bccPositionBefore = l_bccPosition;
  l_bccScalarBefore = l_bccScalar;
  l_bccPosition = texturePosition;
  l_bccScalar = scalar;
}

// After g_dataPos has gone some samples further: where that is beyond the ray's end, back to the end.
void BCCStopAtEnd()
{
  l_bccLast = g_bccSample >= l_bccSteps;
  g_dataPos = g_bccStart + min(g_bccSample, l_bccSteps) * g_dirStep;
}

// Takes the depth of the surface at g_dataPos if it is the first that counts.
void BCCTakeDepth()
{
#ifdef BCC_RENDER_TO_IMAGE
  if (l_updateDepth && g_srcColor.a > 0.0)
  {
    l_opaqueFragPos = g_dataPos;
    l_updateDepth = false;
  }
#endif
  if (!g_bccDepthTaken && g_fragColor.a > in_bccDepthOpacity)
  {
    vec4 p = in_projectionMatrix * (in_modelViewMatrix * (in_volumeMatrix[0] *
      (in_textureDatasetMatrix[0] * vec4(g_dataPos, 1.0))));
    g_bccDepth = 0.5 * (gl_DepthRange.diff * p.z / p.w + gl_DepthRange.near + gl_DepthRange.far);
    g_bccDepthTaken = true;
    g_bccSurface = g_dataPos;
  }
}
