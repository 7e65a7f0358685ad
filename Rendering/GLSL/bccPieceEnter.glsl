// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  // To a sample shortly before the part of a piece.
#ifdef BCC_SLICE
  if (!BCCIsOwned(g_intersection))
  {
    discard;
  }
#else
  {
    vec2 part = BCCFindPart();
    g_bccLastSample = ceil(part.y + 0.01) + 1.0;
    BCCAdvance(max(floor(part.x - 0.01) - 1.0, 0.0));
    g_currentT = g_bccSample;
    if (part.x > g_bccLastSample || !BCCGoToPart())
    {
      discard;
    }
#ifdef BCC_ISOSURFACE
    // VTK's own surfaces need the sample before, for which it counts anew.
    BCCAdvance(-min(g_bccSample, 1.0));
    g_terminatePointMax -= g_bccSample;
    g_currentT = 0.0;
#endif
  }
#endif
