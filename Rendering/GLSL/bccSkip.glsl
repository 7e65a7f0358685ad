// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Leaps over bricks in which nothing is to be seen.

bool g_bccLeft; // whether a leap went beyond the last sample

// The number of bricks along each axis, from a brick on, that are empty; or, if it is not itself, minus
// the number of those that are not, as far as is known.
float BCCCountEmptyBricks(vec4 texel)
{
#ifdef BCC_SKIP_EXTREMUM
  return BCCIsBeaten(texel) ? 1.0 : 0.0;
#else
  return floor(255.0 * texel.r + 0.5) - 128.0;
#endif
}

// The same in samples after this one; -1 if its brick is not empty.
float BCCCountEmptySamples()
{
  float samples = -1.0;
  // This is passed once at most: as a branch there are machines that would compute it in any case.
  while (samples < 0.0 && g_bccSample >= g_bccChecked)
  {
    vec3 way;
    float count = BCCCountEmptyBricks(BCCFetchBrick(way));
    float within = BCCCountSamples(way, max(abs(count), 1.0));
    samples = count > 0.0 ? within : -1.0;
    g_bccChecked = count > 0.0 ? g_bccChecked : g_bccSample + within + 1.0;
  }
  return samples;
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
    float next = g_bccSample + BCCCountSamples(way, max(abs(count), 1.0)) + 1.0;
    g_bccChecked = count > 0.0 ? g_bccChecked : next;
    g_bccSample = count > 0.0 ? next : g_bccSample;
  }
  float samples = g_bccSample - from;
  g_bccSample = from;
  g_bccLeft = samples > 0.0 && BCCLeap(samples);
}
