// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef BCC_INDEPENDENT
  // VTK takes isovalues to be in units of the first component's range.
  for (int i = 0; i < NUMBER_OF_CONTOURS; ++i)
  {
    vec2 range = in_scalarsRange[BCCIsoComponent()];
    l_normValues[i + 1] = (in_isosurfacesValues[i] - range.x) / (range.y - range.x);
  }
#endif
  // The first sample is where the ray enters, somewhat before VTK's first, and the last is where the
  // ray leaves the box or meets what ends it. A depth peel starts where the one before it ended.
  {
    float squaredStep = dot(g_dirStep, g_dirStep);
    float back = dot(g_dataPos - (g_rayOrigin - g_rayJitter), g_dirStep) / squaredStep;
    if (zStart >= 0.0)
    {
      vec4 start = ip_inverseTextureDataAdjusted * (in_inverseVolumeMatrix[0] *
        (in_inverseModelViewMatrix * (in_inverseProjectionMatrix *
          WindowToNDC(gl_FragCoord.x, gl_FragCoord.y, zStart))));
      back = min(back, dot(g_dataPos - start.xyz / start.w, g_dirStep) / squaredStep);
    }
    g_dataPos -= max(back, 0.0) * g_dirStep;
    vec3 far = mix(in_texMin[0], in_texMax[0], greaterThan(g_dirStep, vec3(0.0)));
    vec3 leave = mix((far - g_dataPos) / g_dirStep, vec3(1e20), equal(g_dirStep, vec3(0.0)));
    float terminate = dot(g_terminatePos - g_dataPos, g_dirStep) / squaredStep;
    l_bccSteps = max(min(min(min(leave.x, leave.y), leave.z), terminate), 0.0);
    l_bccFirst = true;
    l_bccWithin = true;
    BCCStartRay();
#ifdef BCC_SKIP_DISTANCE
    BCCStartSkipping();
#endif
    float first = 0.0;
#ifdef BCC_PIECE
    // Two samples before the part and two after it, which tell of surfaces at its borders.
    vec2 part = BCCFindPart();
    if (part.x > part.y + 0.01 || part.x > l_bccSteps + 0.01)
    {
      discard;
    }
    first = max(floor(part.x - 0.01) - 1.0, 0.0);
    l_bccSteps = min(l_bccSteps, floor(part.y + 0.01) + 2.0);
#endif
    BCCAdvance(first);
    BCCAdvanceTo(first);
    l_bccWithin = false;
  }
