// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// A piece of a volume (vtkBCCVolumePiece): rays and their samples are those of the whole, of which
// the ones in the piece's own part are taken.

uniform vec3 in_bccPieceLow;  // the part in lattice coordinates, half open; far beyond the box where
uniform vec3 in_bccPieceHigh; // that ends

float g_bccLastSample; // that may be in the part

bool BCCIsOwned(vec3 texturePosition)
{
  vec3 p = BCCPosition(texturePosition);
  return all(greaterThanEqual(p, in_bccPieceLow)) && all(lessThan(p, in_bccPieceHigh));
}

// How many samples from the ray's first one it enters and leaves the part, but for rounding; the
// former is larger where it misses it.
vec2 BCCFindPart()
{
  vec3 size = g_bccBoxSize;
  vec3 p = g_bccLow + size * g_bccStart;
  vec3 rate = size * g_dirStep;
  rate = mix(rate, vec3(1e-9), lessThan(abs(rate), vec3(1e-9)));
  vec3 a = (in_bccPieceLow - p) / rate;
  vec3 b = (in_bccPieceHigh - p) / rate;
  vec3 enter = min(a, b);
  vec3 leave = max(a, b);
  return vec2(max(max(enter.x, enter.y), max(enter.z, 0.0)),
    min(min(leave.x, leave.y), leave.z));
}

// From this sample on to the first in the part. False if there is none, or the ray ends before it: as
// with VTK, the first sample of all is taken even beyond the box.
bool BCCGoToPart()
{
  while (g_bccSample <= g_bccLastSample && !BCCIsOwned(g_dataPos))
  {
    BCCAdvance(1.0);
    g_currentT += 1.0;
  }
  return g_bccSample <= g_bccLastSample && g_currentT - 1.0 < g_terminatePointMax &&
    (g_bccSample == 0.0 ||
      !(any(greaterThan(max(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMax[0]), vec3(0.0))) ||
        any(greaterThan(min(g_dirStep, vec3(0.0)) * (g_dataPos - in_texMin[0]), vec3(0.0)))));
}
