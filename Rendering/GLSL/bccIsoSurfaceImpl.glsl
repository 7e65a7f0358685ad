// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#if NUMBER_OF_CONTOURS
    {
      float value;
      float isoValue;
      bool rising;
      bool crossed;
      // To the next sample beyond an isovalue, or the last. This loop holds nothing else, as there
      // are machines that compute a branch whether it is taken or not.
      while (true)
      {
        value = BCCIsoScalar(g_dataPos);
        rising = value > l_bccScalar;
        // After a NaN, which compares as neither, the ray starts anew.
        if (l_bccFirst || !(rising || value <= l_bccScalar))
        {
          l_initialIndex = findIsoSurfaceIndex(value, l_normValues);
          l_bccScalar = value;
          l_bccFirst = false;
        }
        isoValue = BCCNextIsoValue(rising);
        crossed = rising ? value > isoValue : value < isoValue;
        if (crossed || l_bccLast)
        {
          break;
        }
        l_bccPosition = g_dataPos;
        l_bccScalar = value;
        g_dataPos += g_dirStep;
        BCCCountStep();
      }

      // All surfaces since the sample before, in their order.
      vec3 samplePosition = g_dataPos;
      vec3 step = samplePosition - l_bccPosition;
      do
      {
        if (crossed)
        {
          float root = BCCFindRoot(
            l_bccPosition, step, l_bccScalar - isoValue, value - isoValue, isoValue);
          g_dataPos = l_bccPosition + root * step;
          if (BCCIsVisible(g_dataPos))
          {
            vec4 vs = vec4(isoValue);
            g_srcColor.a = computeOpacity(vs BCC_COMPONENT_ARGUMENT);
            g_srcColor = computeColor(vs, g_srcColor.a BCC_COMPONENT_ARGUMENT);
            g_srcColor.rgb *= g_srcColor.a;
            g_fragColor = (1.0 - g_fragColor.a) * g_srcColor + g_fragColor;
            BCCTakeDepth();
          }
          l_initialIndex += rising ? 1 : -1;
          isoValue = BCCNextIsoValue(rising);
          crossed = (rising ? value > isoValue : value < isoValue) &&
            g_fragColor.a <= g_opacityThreshold;
        }
      } while (crossed);
      g_dataPos = samplePosition;
      l_bccPosition = samplePosition;
      l_bccScalar = value;
    }
#endif
