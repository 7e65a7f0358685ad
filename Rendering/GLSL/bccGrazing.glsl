// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces that a ray grazes: it may enter and leave one between two samples that are on the
// same side of the isovalue. Then the scalar has an extremum there, of which samples tell.

// The scalar, and its derivative along a step.
float BCCIsoSlope(vec3 texturePosition, vec3 textureStep, out float scalar)
{
  BCC_VALUE gx, gy, gz;
  vec4 value = vec4(0.0);
  vec4 slope = vec4(0.0);
  vec3 p = textureStep * g_bccBoxSize;
  value.BCC_CHANNELS = EvaluateBoxSpline(BCCPosition(texturePosition), gx, gy, gz);
  slope.BCC_CHANNELS = gx * p.x + gy * p.y + gz * p.z;
  vec4 scale = in_volume_scale[0];
  vec4 bias = in_volume_bias[0];
#if BCC_COMPONENTS == 4
  bias += scale * g_bccColorBias;
  scale *= g_bccColorScale;
#endif
  int component = BCCIsoComponent();
  scalar = value[component] * scale[component] + bias[component];
  return slope[component] * scale[component];
}

// Whether the last sample is an extremum among its neighbours, the next of which has this value,
// and the isovalue it points to is not too far for the function between them. A parabola through
// the three would exceed the last by up to an eighth of its second difference.
bool BCCMayGraze(float value)
{
  float rise = l_bccScalar - l_bccScalarBefore;
  float fall = l_bccScalar - value;
  float reach = 2.0 * (rise + fall);
  if (!(rise * fall >= 0.0) || reach == 0.0)
  {
    return false;
  }
  float isoValue = BCCNextIsoValue(reach > 0.0);
  return reach > 0.0 ? isoValue < l_bccScalar + reach : isoValue > l_bccScalar + reach;
}

// Looks for a point beyond the isovalue in a step from start whose scalar has a maximum, for a sign
// of 1, or a minimum, for -1. Returns where in the step it is, or -1: towards a root of the slope, by
// the Illinois variant of regula falsi, until the isovalue is passed or cannot be.
float BCCFindGrazed(vec3 start, vec3 textureStep, float sign, float isoValue, out float scalar)
{
  float s0 = 0.0;
  float s1 = 1.0;
  float slope0 = sign * BCCIsoSlope(start, textureStep, scalar);
  float gap0 = sign * (isoValue - scalar);
  float slope1 = sign * BCCIsoSlope(start + textureStep, textureStep, scalar);
  float gap1 = sign * (isoValue - scalar);
  float weight0 = slope0;
  float weight1 = slope1;
  float kept = 0.0; // the end that the last evaluation kept, -1 or 1
  for (int i = 0; i < 12 && slope0 > 0.0 && slope1 < 0.0; ++i)
  {
    // No function that bends down passes the point where the tangents at both ends meet. Further
    // out, the first two times, the function may bend up.
    float meet = (gap0 - gap1 + slope1 * (s0 - s1)) / (slope0 - slope1);
    if (i > 1 && slope0 * meet < gap0)
    {
      break;
    }
    float s = (s0 * weight1 - s1 * weight0) / (weight1 - weight0);
    float slope = sign * BCCIsoSlope(start + s * textureStep, textureStep, scalar);
    float gap = sign * (isoValue - scalar);
    if (gap < 0.0)
    {
      return s;
    }
    // An end that is kept twice counts half.
    if (slope > 0.0)
    {
      weight1 *= kept > 0.0 ? 0.5 : 1.0;
      s0 = s;
      slope0 = weight0 = slope;
      gap0 = gap;
      kept = 1.0;
    }
    else
    {
      weight0 *= kept < 0.0 ? 0.5 : 1.0;
      s1 = s;
      slope1 = weight1 = slope;
      gap1 = gap;
      kept = -1.0;
    }
  }
  return -1.0;
}

// After BCCMayGraze: whether the ray does graze a surface. If so, a point beyond it becomes the sample
// that g_dataPos and value are of, and the ray goes on from next, to return to the samples after it.
bool BCCGraze(inout float value, inout bool rising, inout bool crossed, inout vec3 next)
{
  bool peak = 2.0 * l_bccScalar > l_bccScalarBefore + value;
  float sign = peak ? 1.0 : -1.0;
  float isoValue = BCCNextIsoValue(peak);
  float scalar;
  bool back = sign * BCCIsoSlope(l_bccPosition, g_dirStep, scalar) < 0.0;
  vec3 start = back ? l_bccPositionBefore : l_bccPosition;
  vec3 textureStep = (back ? l_bccPosition : g_dataPos) - start;
  float s = BCCFindGrazed(start, textureStep, sign, isoValue, scalar);
  if (s >= 0.0)
  {
    g_bccSample -= back ? 2.0 : 1.0;
    next = g_bccStart + g_bccSample * g_dirStep;
    l_bccLast = false;
    l_bccScalar = back ? l_bccScalarBefore : l_bccScalar;
    l_bccPosition = start;
    g_dataPos = start + s * textureStep;
    value = scalar;
    rising = peak;
    l_bccIsoValue = isoValue;
    crossed = true;
  }
  return s >= 0.0;
}
