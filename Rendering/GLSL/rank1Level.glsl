// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Which level of a rank-1 texture a pixel's footprint (du/dx, dv/dx, du/dy, dv/dy) asks for. The
// twins are in Module/Core/Rank1Level.h.

struct Rank1LevelBlend
{
  int Lower;
  int Upper;
  float Weight;
};

// The logarithm of 0 is undefined in GLSL; below the footprint of a pixel far inside a texel
// nothing changes.
float GetRank1Logarithm(float squaredLength)
{
  return 0.5 * log2(max(squaredLength, 1e-30));
}

float GetRank1MipLevel(vec4 footprint, vec2 density)
{
  vec2 x = density * footprint.xy;
  vec2 y = density * footprint.zw;
  return GetRank1Logarithm(max(dot(x, x), dot(y, y)));
}

vec2 GetRank1MemberLevel(vec4 footprint, vec2 density)
{
  vec2 u = density.x * footprint.xz;
  vec2 v = density.y * footprint.yw;
  return vec2(GetRank1Logarithm(dot(u, u)), GetRank1Logarithm(dot(v, v)));
}

int GetNearestRank1Level(float level, int levels)
{
  return int(clamp(ceil(level - 0.5), 0.0, float(levels) - 1.0));
}

Rank1LevelBlend GetRank1LevelBlend(float level, int levels)
{
  float inside = clamp(level, 0.0, float(levels) - 1.0);
  float lower = min(floor(inside), max(float(levels) - 2.0, 0.0));
  return Rank1LevelBlend(
    int(lower), int(min(lower + 1.0, float(levels) - 1.0)), inside - lower);
}

ivec2 GetRank1Member(vec2 level, ivec2 levels)
{
  const float tolerance = 1.0 / 256.0;
  vec2 most = vec2(levels) - 1.0;
  vec2 d = clamp(level, vec2(0.0), most);
  float ratio = ceil(d.x - d.y - 0.5);
  float first = max(0.0, ratio);
  float last = min(most.x, most.y + ratio);
  float i = ceil(0.5 * (d.x + d.y + ratio - tolerance));
  float column = clamp(i, first, last);
  return ivec2(vec2(column, column - ratio));
}
