// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Leaps over bricks in which nothing is to be seen.

bool g_bccLeft; // whether a leap went beyond the last sample

// The number of bricks along each axis, from a brick on, that are empty; 0 if it is not itself.
float BCCCountEmptyBricks(vec4 texel)
{
#ifdef BCC_SKIP_EXTREMUM
  return BCCIsBeaten(texel) ? 1.0 : 0.0;
#else
  return floor(255.0 * texel.r + 0.5);
#endif
}

// How many samples after this one are in the same empty bricks, or -1 if its own is not empty.
float BCCCountEmptySamples()
{
  vec3 way;
  float count = BCCCountEmptyBricks(BCCFetchBrick(way));
  return count > 0.0 ? BCCCountSamples(way, count) : -1.0;
}

// Passes some samples. Whether that is beyond the last, as VTK ends a ray: after the sample before.
bool BCCLeap(float samples)
{
  g_currentT += samples;
  BCCAdvance(samples);
  return g_currentT - 1.0 >= g_terminatePointMax ||
    any(greaterThan(max(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMax[0]), vec3(0.0))) ||
    any(greaterThan(min(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMin[0]), vec3(0.0)));
}

// To the first sample from this one on that is not in an empty brick.
void BCCSkipEmpty()
{
  float from = g_bccSample;
  while (g_bccSample >= g_bccChecked && g_bccSample < g_bccRayEnd)
  {
    vec3 way;
    float count = BCCCountEmptyBricks(BCCFetchBrick(way));
    float next = g_bccSample + BCCCountSamples(way, max(count, 1.0)) + 1.0;
    g_bccChecked = count > 0.0 ? g_bccChecked : next;
    g_bccSample = count > 0.0 ? next : g_bccSample;
  }
  float samples = g_bccSample - from;
  g_bccSample = from;
  g_bccLeft = samples > 0.0 && BCCLeap(samples);
}
