// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  // The first sample is where the ray enters, at most one step before VTK's first, and the last is
  // where the ray leaves the box or meets what ends it.
  {
    float squaredStep = dot(g_dirStep, g_dirStep);
    float back = dot(g_dataPos - (g_rayOrigin - g_rayJitter), g_dirStep) / squaredStep;
    g_dataPos -= clamp(back, 0.0, 1.0) * g_dirStep;
    vec3 far = mix(in_texMin[0], in_texMax[0], greaterThan(g_dirStep, vec3(0.0)));
    vec3 leave = mix((far - g_dataPos) / g_dirStep, vec3(1e20), equal(g_dirStep, vec3(0.0)));
    float terminate = dot(g_terminatePos - g_dataPos, g_dirStep) / squaredStep;
    l_bccSteps = min(min(min(leave.x, leave.y), leave.z), terminate);
    l_bccFirst = true;
    l_bccLast = l_bccSteps <= 0.0;
  }
