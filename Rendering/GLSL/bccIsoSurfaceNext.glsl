// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// To the next sample of an isosurface's ray that matters, but to the given one at least.
//
// In empty bricks about a sample no isovalue is met. Such bricks follow one another, and the ray
// stays in its interval between isovalues up to the last sample in them. This and the one before
// are needed to tell whether a surface is met or grazed behind them, as are the first two samples
// in them for what is ahead. After a leap the ray starts anew.
void BCCAdvanceTo(float least)
{
#ifdef BCC_SKIP_DISTANCE
  bool leaping = l_bccWithin;
  l_bccWithin = false;
  float samples;
  do
  {
    samples = BCCCountEmptySamples();
    l_bccWithin = l_bccWithin || samples > 0.0;
    BCCAdvance(leaping ? max(samples, 0.0) : 0.0);
    BCCStopAtEnd();
  } while (leaping && samples > 0.0 && !l_bccLast);
  if (!l_bccLast)
  {
    BCCAdvance(max(-1.0, least - g_bccSample));
    BCCStopAtEnd();
  }
  l_bccFirst = l_bccFirst || g_bccSample > least;
#else
  BCCAdvance(least - g_bccSample);
  BCCStopAtEnd();
#endif
}
