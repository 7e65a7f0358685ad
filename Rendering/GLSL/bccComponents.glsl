// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// What VTK's slices ask for, of several independent components: their colours together, blended as
// VTK's composite blending does at a sample.

float computeOpacity(vec4 scalar)
{
  return 1.0; // It is in the colour.
}

vec4 computeColor(vec4 scalar, float opacity)
{
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < in_noOfComponents; ++i)
  {
    vec4 color = computeColor(scalar, computeOpacity(scalar, i), i);
    float weight = in_componentWeight[i];
    total += color.a * weight;
    sum += weight > 0.0 ? vec4(color.rgb * color.a * weight, color.a * color.a) : vec4(0.0);
  }
  sum.a = total > 0.0 ? sum.a / total : 0.0;
  return total > 0.0 ? sum : vec4(0.0);
}
