// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Before a ray that looks for an extremum is followed, its samples in the brick with the farthest
// bound are taken: what they beat need not be looked at. It goes for rays of which every sample counts.

// The number of the first sample in that brick, as far as the first component tells, and how many
// follow it there.
vec2 BCCFindFarthestBrick()
{
  vec2 found = vec2(0.0);
  float farthest = -2.0;
  bool left;
  do
  {
    vec3 way;
    float bound = BCCSense * BCCFetchBrick(way).r;
    float samples = BCCCountSamples(way, 1.0);
    found = bound > farthest ? vec2(g_bccSample, samples) : found;
    farthest = max(bound, farthest);
    left = BCCLeap(samples + 1.0);
  } while (!left);
  return found;
}

// To a sample of the ray, from another.
void BCCReturnTo(float number)
{
  g_currentT += number - g_bccSample;
  BCCAdvance(number - g_bccSample);
}

// Sets g_bccBeaten. No number, NaN, beats none.
void BCCLookAhead()
{
  vec2 brick = BCCFindFarthestBrick();
  vec4 farthest = vec4(-2.0);
  bool left = false;
  BCCReturnTo(brick.x);
  for (float n = 0.0; n <= brick.y && !left; ++n)
  {
    vec4 value = BCCSense * (BCCLookUp(g_dataPos) * in_volume_scale[0] + in_volume_bias[0]);
    farthest = mix(farthest, value, greaterThan(value, farthest));
    left = BCCLeap(1.0);
  }
  BCCReturnTo(0.0);
  // A bound that is as far may be that of the extremum itself. Bounds are multiples of 1 / 255.
  g_bccBeaten = (ceil(255.0 * min(farthest, BCCSense * BCCMostBound)) - 0.5) / 255.0;
}
