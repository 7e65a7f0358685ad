// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where only the maximum or minimum along a ray counts: bricks whose bounds are beaten by what has been
// found are empty, as are those that will be. Values and bounds are multiplied by BCCSense, to have
// maxima be looked for in either case.

#ifdef BCC_SKIP_MINIMUM
#define BCC_FOUND l_minValue
const float BCCSense = -1.0;
const float BCCMostBound = 0.0; // Bounds are from 0 to 1.
#else
#define BCC_FOUND l_maxValue
const float BCCSense = 1.0;
const float BCCMostBound = 1.0;
#endif

#if BCC_COMPONENTS == 1
#define BCC_BOUNDS rr
#define BCC_FOUND_CHANNELS ww
#else
#define BCC_BOUNDS BCC_CHANNELS
#define BCC_FOUND_CHANNELS BCC_CHANNELS
#endif

vec4 g_bccBeaten = vec4(-2.0); // bounds that the ray is known to beat

// Whether no sample of a brick with these bounds changes what is found.
bool BCCIsBeaten(vec4 bounds)
{
  vec4 found = l_firstValue ? vec4(-2.0) : BCCSense * BCC_FOUND;
  return all(lessThanEqual(BCCSense * bounds.BCC_BOUNDS,
    max(found.BCC_FOUND_CHANNELS, g_bccBeaten.BCC_BOUNDS)));
}
