// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#if NUMBER_OF_CONTOURS
    {
      float value;
      bool rising;
      bool crossed;
      bool grazing;
      // To the next sample beyond an isovalue or near one at an extremum, or the last. This loop holds
      // nothing else, as there are machines that compute a branch whether it is taken or not.
      while (true)
      {
        value = BCCIsoScalar(g_dataPos);
        rising = value > l_bccScalar;
        // After a NaN, which compares as neither, the ray starts anew.
        if (l_bccFirst || !(rising || value <= l_bccScalar))
        {
          BCCEnterInterval(findIsoSurfaceIndex(value, l_normValues));
          BCCPassSample(g_dataPos, value);
          BCCPassSample(g_dataPos, value); // There is none before.
          l_bccFirst = false;
        }
        l_bccIsoValue = BCCNextIsoValue(rising);
        crossed = rising ? value > l_bccIsoValue : value < l_bccIsoValue;
        grazing = BCCMayGraze(value);
        if (crossed || grazing || l_bccLast)
        {
          break;
        }
        BCCPassSample(g_dataPos, value);
        BCCAdvanceTo(g_bccSample + 1.0);
      }

      vec3 next = g_dataPos;
      bool grazed = grazing && BCCGraze(value, rising, crossed, next);

      // All surfaces since the sample before, in their order.
      vec3 samplePosition = g_dataPos;
      l_bccStep = samplePosition - l_bccPosition;
      do
      {
        if (crossed)
        {
          g_dataPos = l_bccPosition +
            FindRoot(l_bccScalar - l_bccIsoValue, value - l_bccIsoValue) * l_bccStep;
          if (BCCIsVisible(g_dataPos))
          {
            vec4 vs = vec4(l_bccIsoValue);
#ifdef BCC_TRANSFER_2D
            g_gradients_0[0] = computeGradient(g_dataPos, 0, in_volume[0], 0);
#endif
            g_srcColor.a = computeOpacity(vs BCC_COMPONENT_ARGUMENT);
            g_srcColor = computeColor(vs, g_srcColor.a BCC_COMPONENT_ARGUMENT);
            g_srcColor.rgb *= g_srcColor.a;
            g_fragColor = (1.0 - g_fragColor.a) * g_srcColor + g_fragColor;
            BCCTakeDepth();
          }
          BCCEnterInterval(l_initialIndex + (rising ? 1 : -1));
          l_bccIsoValue = BCCNextIsoValue(rising);
          crossed = (rising ? value > l_bccIsoValue : value < l_bccIsoValue) &&
            g_fragColor.a <= g_opacityThreshold;
        }
      } while (crossed);
      g_dataPos = next;
      l_bccWithin = false;
      BCCPassSample(samplePosition, value);
      if (grazed)
      {
        BCCPassSample(samplePosition, value); // The one before is not to be met again.
      }
    }
#endif
