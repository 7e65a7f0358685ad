// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The samples of a ray. The n-th is at g_bccStart + n g_dirStep, the same however many were left
// out before it.

vec3 g_bccStart;
float g_bccSample;

void BCCStartRay()
{
  g_bccStart = g_dataPos;
  g_bccSample = 0.0;
}

// After VTK's g_dataPos += g_dirStep, whose sum of many roundings it replaces.
void BCCAdvance(float samples)
{
  g_bccSample += samples;
  g_dataPos = g_bccStart + g_bccSample * g_dirStep;
}
