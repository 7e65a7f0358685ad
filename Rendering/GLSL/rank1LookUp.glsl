// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The interpolated value of a level, and the colour of a place in the picture by the levels that
// its footprint asks for.

vec4 LookUpLevel(int level, vec2 uv)
{
  Rank1Texture texture = GetRank1Texture(level);
#if RANK1_STENCIL == 1
  return FetchRank1Texel(level, FindRank1Nearest(texture, uv));
#else
  int texels[RANK1_STENCIL];
  float weights[RANK1_STENCIL];
  RANK1_FIND(texture, uv, texels, weights);
  vec4 value = vec4(0.0);
  for (int i = 0; i < RANK1_STENCIL; ++i)
  {
    value += weights[i] * FetchRank1Texel(level, texels[i]);
  }
  return value;
#endif
}

// Members of an r-set are in rows of RANK1_SET_COLUMNS.
vec4 LookUpMember(int column, int row, vec2 uv)
{
  return LookUpLevel(row * RANK1_SET_COLUMNS + column, uv);
}

vec4 LookUpFootprint(vec2 uv, vec4 footprint)
{
#if RANK1_LEVELS == 1
  return LookUpLevel(0, uv);
#elif defined(RANK1_R_SET)
  const ivec2 levels = ivec2(RANK1_SET_COLUMNS, RANK1_LEVELS / RANK1_SET_COLUMNS);
  vec2 level = GetRank1MemberLevel(footprint, Rank1Density);
#ifdef RANK1_TRILINEAR
  Rank1LevelBlend u = GetRank1LevelBlend(level.x, levels.x);
  Rank1LevelBlend v = GetRank1LevelBlend(level.y, levels.y);
  vec4 low = mix(LookUpMember(u.Lower, v.Lower, uv), LookUpMember(u.Upper, v.Lower, uv), u.Weight);
  vec4 high = mix(LookUpMember(u.Lower, v.Upper, uv), LookUpMember(u.Upper, v.Upper, uv), u.Weight);
  return mix(low, high, v.Weight);
#else
  ivec2 member = GetRank1Member(level, levels);
  return LookUpMember(member.x, member.y, uv);
#endif
#else
  float level = GetRank1MipLevel(footprint, Rank1Density);
#ifdef RANK1_TRILINEAR
  Rank1LevelBlend blend = GetRank1LevelBlend(level, RANK1_LEVELS);
  return mix(LookUpLevel(blend.Lower, uv), LookUpLevel(blend.Upper, uv), blend.Weight);
#else
  return LookUpLevel(GetNearestRank1Level(level, RANK1_LEVELS), uv);
#endif
#endif
}

vec4 GetRank1Color(vec2 uv, vec4 footprint)
{
  vec4 value = LookUpFootprint(uv, footprint);
#if RANK1_COMPONENTS == 1
  return vec4(value.rrr, 1.0);
#elif RANK1_COMPONENTS == 2
  return value.rrrg;
#elif RANK1_COMPONENTS == 3
  return vec4(value.rgb, 1.0);
#else
  return value;
#endif
}
