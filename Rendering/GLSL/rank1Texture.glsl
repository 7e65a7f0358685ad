// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The numbers of each level of a texture as Rank1Texture, and its texels: in index order, tile after
// tile, in rows of a power of two. What is above, constants of this texture, is written by
// vtkRank1TextureInput.

uniform sampler2D in_rank1Texels;

// The twin is in Module/Core/Rank1Index.h. Integers up to 2^24 are floats.
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
  vec4 index = Rank1Indices[level]; // n, k, l and the level's first row
  vec4 shares = Rank1Shares[level]; // k / n, l / n, 1 / n
  vec4 shape = Rank1Shape[level];   // S, T, and of the metric what is not 1
  return Rank1Texture(Rank1ToBasis[level], vec3(1.0, shape.zw), shares.xy, shares.z,
    int(index.x), ivec2(index.yz), ivec4(Rank1Basis[level]), ivec2(shape.xy));
}

vec4 FetchRank1Texel(int level, int texel)
{
  int column = texel & ((1 << Rank1Log2Columns) - 1);
  int row = int(Rank1Indices[level].w) + (texel >> Rank1Log2Columns);
  return texelFetch(in_rank1Texels, ivec2(column, row), 0);
}
