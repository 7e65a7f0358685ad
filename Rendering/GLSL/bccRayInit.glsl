// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  BCCStartRay();
#ifdef BCC_CUT_SLICE
  // VTK shows a slice where it is clipped, too, if the ray is not clipped altogether.
  g_exit = dot(g_intersection - g_dataPos, g_dirStep) < -0.01 * dot(g_dirStep, g_dirStep) ||
    dot(g_terminatePos - g_intersection, g_dirStep) < -0.01 * dot(g_dirStep, g_dirStep);
#endif
#if defined(BCC_SKIP_DISTANCE) || defined(BCC_SKIP_EXTREMUM)
  BCCStartSkipping();
#endif
#ifdef BCC_LOOK_AHEAD
  BCCLookAhead();
#endif
