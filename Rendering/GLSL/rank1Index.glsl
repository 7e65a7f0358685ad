// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Where a point is on the lattice, and the number of a lattice point's texel. The twins are in
// Module/Core/Rank1Index.h.

struct Rank1Site
{
  ivec2 Tile;
  ivec2 Cell;
  vec2 Fraction;
};

Rank1Site FindRank1Site(Rank1Texture texture, vec2 uv)
{
  vec2 p = uv - floor(uv);
#ifdef RANK1_TILED
  p *= vec2(texture.Tiles);
  ivec2 tile = min(ivec2(p), texture.Tiles - 1);
  p -= vec2(tile);
#else
  ivec2 tile = ivec2(0);
#endif
  vec2 st = vec2(dot(texture.ToBasis.xy, p), dot(texture.ToBasis.zw, p));
  vec2 cell = floor(st);
  return Rank1Site(tile, ivec2(cell), st - cell);
}

// Integers wrap around in GLSL.
int Rank1Sum(int a, int x, int b, int y, int c, int z)
{
  return a * x + b * y - c * z;
}

int Rank1Modulo(int x, int n, float reciprocal)
{
  int rest = x - int(floor(float(x) * reciprocal)) * n;
  int positive = rest < 0 ? rest + n : rest;
  return positive >= n ? positive - n : positive;
}

int Rank1Index(Rank1Texture texture, ivec2 st)
{
  int n = texture.NumberOfPoints;
#ifdef RANK1_POWER_OF_TWO
  return Rank1Sum(st.x, texture.Indices.x, st.y, texture.Indices.y, 0, 0) & (n - 1);
#else
  int turns = int(floor(dot(vec2(st), texture.IndexShares)));
  int rest = Rank1Sum(st.x, texture.Indices.x, st.y, texture.Indices.y, turns, n);
  int positive = rest < 0 ? rest + n : rest;
  return positive >= n ? positive - n : positive;
#endif
}

int Rank1Texel(Rank1Texture texture, ivec2 tile, ivec2 st)
{
  int index = Rank1Index(texture, st);
#ifdef RANK1_TILED
  int n = texture.NumberOfPoints;
  int x = Rank1Sum(st.x, texture.Basis.x, st.y, texture.Basis.z, 0, 0);
  int y = Rank1Sum(st.x, texture.Basis.y, st.y, texture.Basis.w, 0, 0);
  int column = tile.x + (x - Rank1Modulo(x, n, texture.Reciprocal)) / n;
  int row = tile.y + (y - Rank1Modulo(y, n, texture.Reciprocal)) / n;
  vec2 reciprocals = 1.0 / vec2(texture.Tiles);
  int wrappedColumn = Rank1Modulo(column, texture.Tiles.x, reciprocals.x);
  int wrappedRow = Rank1Modulo(row, texture.Tiles.y, reciprocals.y);
  index += n * (wrappedColumn + texture.Tiles.x * wrappedRow);
#endif
  return index;
}
