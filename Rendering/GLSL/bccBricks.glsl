// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The bricks (BCCBricks) along a ray. A brick's texel is the distance to the next brick that matters,
// or from one that does to the next that does not (FindSignedBrickDistances); or, with
// BCC_SKIP_EXTREMUM, bounds of the scalars there.

uniform samplerBuffer in_bccBricks;
uniform vec3 in_bccBrickOrigin; // of the first brick, in lattice coordinates
uniform int in_bccBrickCounts[3]; // along each axis

const float BCCBrickEdge = 5.0; // BCCBricks::Edge
ivec2 g_bccBrickPitch = // bricks of a row and of a slice
  ivec2(in_bccBrickCounts[0], in_bccBrickCounts[0] * in_bccBrickCounts[1]);
vec3 g_bccLastBrick =
  vec3(in_bccBrickCounts[0] - 1, in_bccBrickCounts[1] - 1, in_bccBrickCounts[2] - 1);
vec3 g_bccBrickStart; // where the ray's first sample is, in bricks, and a step of it
vec3 g_bccBrickStep;
vec3 g_bccBrickSamples; // samples from face to face
vec3 g_bccBrickEntry;   // the faces where it enters bricks, 0 or 1
float g_bccRayEnd;      // a number that only samples beyond the last have
float g_bccChecked;     // the first sample that may be in an empty brick

void BCCStartSkipping()
{
  vec3 bricks = g_bccBoxSize / BCCBrickEdge;
  g_bccBrickStart = (g_bccLow - in_bccBrickOrigin) / BCCBrickEdge + bricks * g_bccStart;
  g_bccBrickStep = bricks * g_dirStep;
  g_bccBrickSamples = 1.0 / max(abs(g_bccBrickStep), vec3(1e-9));
  g_bccBrickEntry = vec3(lessThan(g_bccBrickStep, vec3(0.0)));
  vec3 far = mix(in_texMin[0], in_texMax[0], greaterThan(g_dirStep, vec3(0.0)));
  vec3 leave = mix((far - g_bccStart) / g_dirStep, vec3(1e20), equal(g_dirStep, vec3(0.0)));
  g_bccRayEnd = min(min(min(leave.x, leave.y), leave.z), g_terminatePointMax) + 2.0;
  g_bccChecked = 0.0;
}

// The texel of this sample's brick. `way` is how far from where the ray entered the sample is.
vec4 BCCFetchBrick(out vec3 way)
{
  vec3 q = g_bccBrickStart + g_bccSample * g_bccBrickStep;
  vec3 corner = clamp(floor(q), vec3(0.0), g_bccLastBrick);
  way = abs(q - corner - g_bccBrickEntry);
  ivec3 brick = ivec3(corner);
  return texelFetch(
    in_bccBricks, brick.x + brick.y * g_bccBrickPitch.x + brick.z * g_bccBrickPitch.y);
}

// How many samples after this one are in so many bricks along each axis. Somewhat before the far
// faces the bricks count as left, so that rounding does no harm.
float BCCCountSamples(vec3 way, float bricks)
{
  vec3 samples = (bricks - 1e-4 - way) * g_bccBrickSamples;
  return floor(max(min(min(samples.x, samples.y), samples.z), 0.0));
}
