// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// What takes the place of VTK's look-ups and gradients.

#if BCC_COMPONENTS == 4
// They make colours of stored values, as VTK's own textures do.
uniform vec4 in_bccColors[2];
vec4 g_bccColorScale = in_bccColors[0];
vec4 g_bccColorBias = in_bccColors[1];
#endif

#ifdef BCC_SHARED_GRADIENTS
BCCFrame g_bccFrame; // of the last look-up, and its coefficients
BCC_VALUE g_bccCoefficients[BCC_STENCIL];

BCC_VALUE EvaluateShared(out BCC_VALUE gx, out BCC_VALUE gy, out BCC_VALUE gz)
{
  return EvaluateInFrame(g_bccFrame, g_bccCoefficients, gx, gy, gz);
}
#endif

// In the place of texture3D(in_volume[0], texturePosition).
vec4 BCCLookUp(vec3 texturePosition)
{
  BCC_VALUE gx, gy, gz;
  vec4 value = vec4(0.0, 0.0, 0.0, 1.0);
#ifdef BCC_SHARED_GRADIENTS
  g_bccFrame = FindBCCFrame(BCCPosition(texturePosition));
  FetchInFrame(g_bccFrame, g_bccCoefficients);
  value.BCC_CHANNELS = EvaluateShared(gx, gy, gz);
#else
  value.BCC_CHANNELS = EvaluateBoxSpline(BCCPosition(texturePosition), gx, gy, gz);
#endif
#if BCC_COMPONENTS == 4
  value = value * g_bccColorScale + g_bccColorBias;
#endif
  return value;
}

uniform vec3 in_bccToGradient[3]; // from derivatives along lattice coordinates to the volume's system
mat3 g_bccToEye = transpose(mat3(in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix));

// The direction of a gradient as seen from the camera: of ours, which are in the volume's own system,
// or of VTK's differences, along the image's axes. VTK's lights need it; it would take texture
// coordinates for it, and shade long boxes wrongly.
vec3 BCCToEye(vec3 gradient)
{
#ifndef BCC_ANALYTIC_GRADIENTS
  gradient = mat3(normalize(in_bccToGradient[0]), normalize(in_bccToGradient[1]),
    normalize(in_bccToGradient[2])) * gradient;
#endif
  return g_bccToEye * gradient;
}

#ifdef BCC_ANALYTIC_GRADIENTS
mat3 g_bccToGradient = mat3(in_bccToGradient[0], in_bccToGradient[1], in_bccToGradient[2]);
float g_bccEdge = dot(in_cellSpacing[0], vec3(1.0 / 3.0)); // of a cell, on average

// VTK's function of this name takes differences. Here c is the component; the other arguments are
// VTK's and always the same. The direction is that of the gradient in the volume's own system. With
// gradient opacity it is a unit vector and w is the magnitude as VTK scales it: per average cell
// edge, in units of a quarter of the scalar range. Else w is -1.
vec4 computeGradient(in vec3 texPos, in int c, in sampler3D volume, in int index)
{
  BCC_VALUE gx, gy, gz;
#ifdef BCC_SHARED_GRADIENTS
  EvaluateShared(gx, gy, gz); // texPos is where VTK has just looked up
#else
  EvaluateBoxSpline(BCCPosition(texPos), gx, gy, gz);
#endif
#if BCC_COMPONENTS == 1
  vec3 gradient = vec3(gx, gy, gz);
#else
  vec3 gradient = vec3(gx[c], gy[c], gz[c]);
#endif
  // Of small numbers, as floats hold no squares of large ones.
  float range = in_scalarsRange[c].y - in_scalarsRange[c].x;
  gradient = g_bccToGradient * (gradient * (g_bccEdge / (range != 0.0 ? range : 1.0)));
#ifdef BCC_GRADIENT_OPACITY
  float magnitude = length(gradient);
  vec3 direction = magnitude > 0.0 ? normalize(gradient) : vec3(0.0);
  return vec4(direction, clamp(4.0 * magnitude, 0.0, 1.0));
#else
  return vec4(gradient, -1.0);
#endif
}
#endif
