// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Leaps over bricks (BCCBricks) in which nothing is to be seen. A brick's texel is the distance to
// the next brick that matters, in bricks along the axis where it is largest; or, with
// BCC_SKIP_MAXIMUM or BCC_SKIP_MINIMUM, bounds of the scalars there.

uniform sampler3D in_bccBricks;
uniform vec3 in_bccBrickOrigin; // of the first brick, in lattice coordinates

const float BCCBrickEdge = 5.0; // BCCBricks::Edge
bool g_bccLeft; // whether a leap went beyond the last sample

// The number of bricks along each axis, from a brick on, that are empty; 0 if it is not itself.
float BCCCountEmptyBricks(ivec3 brick)
{
  vec4 texel = texelFetch(in_bccBricks, brick, 0);
#if defined(BCC_SKIP_MAXIMUM) && BCC_COMPONENTS == 1
  return !l_firstValue && texel.r <= l_maxValue.w ? 1.0 : 0.0;
#elif defined(BCC_SKIP_MAXIMUM)
  return !l_firstValue && all(lessThanEqual(texel.BCC_CHANNELS, l_maxValue.BCC_CHANNELS)) ? 1.0 : 0.0;
#elif defined(BCC_SKIP_MINIMUM) && BCC_COMPONENTS == 1
  return !l_firstValue && texel.r >= l_minValue.w ? 1.0 : 0.0;
#elif defined(BCC_SKIP_MINIMUM)
  return !l_firstValue && all(greaterThanEqual(texel.BCC_CHANNELS, l_minValue.BCC_CHANNELS)) ? 1.0 : 0.0;
#else
  return floor(255.0 * texel.r + 0.5);
#endif
}

// How many samples after this one are in the same empty bricks, or -1 if its own is not empty.
// Somewhat before the far faces the bricks count as left, so that rounding does no harm.
float BCCCountEmptySamples()
{
  vec3 q = (BCCPosition(g_dataPos) - in_bccBrickOrigin) / BCCBrickEdge;
  ivec3 brick = clamp(ivec3(q), ivec3(0), textureSize(in_bccBricks, 0) - 1);
  float count = BCCCountEmptyBricks(brick);
  vec3 rate = (in_bccHigh - in_bccLow) / BCCBrickEdge * g_dirStep;
  vec3 inside = q - vec3(brick);
  vec3 way = mix(inside - 1.0, -inside, greaterThan(rate, vec3(0.0))) + (count - 1e-4);
  vec3 samples = way / max(abs(rate), vec3(1e-9));
  float least = floor(max(min(min(samples.x, samples.y), samples.z), 0.0));
  return count > 0.0 ? least : -1.0;
}

// To the first sample from this one on that is not in an empty brick.
void BCCSkipEmpty()
{
  float samples;
  g_bccLeft = false;
  do
  {
    samples = BCCCountEmptySamples() + 1.0;
    g_currentT += samples;
    BCCAdvance(samples);
    // As VTK ends a ray, after the sample before.
    g_bccLeft = samples > 0.0 &&
      (g_currentT - 1.0 >= g_terminatePointMax ||
        any(greaterThan(max(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMax[0]), vec3(0.0))) ||
        any(greaterThan(min(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMin[0]), vec3(0.0))));
  } while (samples > 0.0 && !g_bccLeft);
}
