// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The numbers of each level of a texture (vtkRank1TextureInput), and its texels: in index order,
// tile after tile, in rows of a power of two.

uniform vec4 in_rank1ToBasis[RANK1_LEVELS];
uniform vec4 in_rank1Index[RANK1_LEVELS];  // n, k, l and the level's first row
uniform vec4 in_rank1Shares[RANK1_LEVELS]; // k / n, l / n, 1 / n
uniform vec4 in_rank1Basis[RANK1_LEVELS];
uniform vec4 in_rank1Shape[RANK1_LEVELS]; // S, T, and of the metric what is not 1
uniform sampler2D in_rank1Texels;
uniform int in_rank1Log2Columns;

// The twin is in Module/Core/Rank1Interpolation.h. Integers up to 2^24 are floats.
struct Rank1Texture
{
  vec4 ToBasis;
  vec3 Metric;
  vec2 IndexShares;
  float Reciprocal;
  int NumberOfPoints;
  ivec2 Indices;
  ivec4 Basis;
  ivec2 Tiles;
};

Rank1Texture GetRank1Texture(int level)
{
  vec4 index = in_rank1Index[level];
  vec4 shares = in_rank1Shares[level];
  vec4 shape = in_rank1Shape[level];
  return Rank1Texture(in_rank1ToBasis[level], vec3(1.0, shape.zw), shares.xy, shares.z,
    int(index.x), ivec2(index.yz), ivec4(in_rank1Basis[level]), ivec2(shape.xy));
}

vec4 FetchRank1Texel(int level, int texel)
{
  int column = texel & ((1 << in_rank1Log2Columns) - 1);
  int row = int(in_rank1Index[level].w) + (texel >> in_rank1Log2Columns);
  return texelFetch(in_rank1Texels, ivec2(column, row), 0);
}
