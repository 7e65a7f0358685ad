// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#if NUMBER_OF_CONTOURS
    {
      float value = BCCIsoScalar(g_dataPos);
      vec3 samplePosition = g_dataPos;
      bool rising = value > l_bccScalar;
      // l_initialIndex is the interval of isovalues that the last sample is in. After a NaN, which
      // compares as neither, the ray starts anew.
      if (l_bccFirst || !(rising || value <= l_bccScalar))
      {
        l_initialIndex = findIsoSurfaceIndex(value, l_normValues);
        l_bccScalar = value;
        l_bccFirst = false;
      }
      for (int i = 0; i <= NUMBER_OF_CONTOURS; ++i)
      {
        l_initialIndex = clamp(l_initialIndex, 0, NUMBER_OF_CONTOURS);
        float isoValue = l_normValues[rising ? l_initialIndex + 1 : l_initialIndex];
        if (g_fragColor.a > g_opacityThreshold || !(rising ? value > isoValue : value < isoValue))
        {
          break;
        }
        l_initialIndex += rising ? 1 : -1;
        vec3 step = samplePosition - l_bccPosition;
        g_dataPos = l_bccPosition +
          BCCFindRoot(l_bccPosition, step, l_bccScalar - isoValue, value - isoValue, isoValue) * step;
        if (BCCIsVisible(g_dataPos))
        {
          vec4 vs = vec4(isoValue);
          g_srcColor.a = computeOpacity(vs BCC_COMPONENT_ARGUMENT);
          g_srcColor = computeColor(vs, g_srcColor.a BCC_COMPONENT_ARGUMENT);
          g_srcColor.rgb *= g_srcColor.a;
          g_fragColor = (1.0 - g_fragColor.a) * g_srcColor + g_fragColor;
#ifdef BCC_RENDER_TO_IMAGE
          if (l_updateDepth && g_srcColor.a > 0.0)
          {
            l_opaqueFragPos = g_dataPos;
            l_updateDepth = false;
          }
#endif
          if (g_bccDepthFound == 0.0 && g_fragColor.a > in_bccDepthOpacity)
          {
            g_bccDepth = BCCWindowDepth(g_dataPos);
            g_bccDepthFound = 1.0;
          }
        }
        g_dataPos = samplePosition;
      }
      l_bccPosition = g_dataPos;
      l_bccScalar = value;
    }
#endif
