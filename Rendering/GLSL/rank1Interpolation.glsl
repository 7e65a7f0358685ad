// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Which texels a point takes, and with what weights: the nearest one, by bilinear and by
// barycentric interpolation. The twins are in Module/Core/Rank1Interpolation.h.

int FindRank1Nearest(Rank1Texture texture, vec2 uv)
{
  Rank1Site site = FindRank1Site(texture, uv);
  vec2 f = site.Fraction;
  vec3 m = texture.Metric;
  float d10 = m.x * (1.0 - 2.0 * f.x) - m.y * f.y;
  float d01 = m.z * (1.0 - 2.0 * f.y) - m.y * f.x;
  bool right0 = d10 < 0.0;
  bool right1 = d10 + m.y < 0.0;
  bool up = d01 + (right1 ? d10 + m.y : 0.0) < (right0 ? d10 : 0.0);
  return Rank1Texel(texture, site.Tile, site.Cell + ivec2(up ? right1 : right0, up));
}

void FindRank1Bilinear(Rank1Texture texture, vec2 uv, out int texels[4], out float weights[4])
{
  Rank1Site site = FindRank1Site(texture, uv);
  vec2 f = site.Fraction;
  texels[0] = Rank1Texel(texture, site.Tile, site.Cell);
  texels[1] = Rank1Texel(texture, site.Tile, site.Cell + ivec2(1, 0));
  texels[2] = Rank1Texel(texture, site.Tile, site.Cell + ivec2(0, 1));
  texels[3] = Rank1Texel(texture, site.Tile, site.Cell + ivec2(1, 1));
  weights[0] = (1.0 - f.x) * (1.0 - f.y);
  weights[1] = f.x * (1.0 - f.y);
  weights[2] = (1.0 - f.x) * f.y;
  weights[3] = f.x * f.y;
}

struct Rank1Triangle
{
  ivec2 Corner;
  int Sign;
  vec3 Barycentric;
};

Rank1Triangle FindRank1Triangle(Rank1Site site)
{
  vec2 f = site.Fraction;
  bool upper = f.x + f.y > 1.0;
  vec2 bc = upper ? 1.0 - f : f;
  return Rank1Triangle(
    site.Cell + int(upper), upper ? -1 : 1, vec3(1.0 - bc.x - bc.y, bc));
}

void FindRank1Barycentric(Rank1Texture texture, vec2 uv, out int texels[3], out float weights[3])
{
  Rank1Site site = FindRank1Site(texture, uv);
  Rank1Triangle triangle = FindRank1Triangle(site);
  texels[0] = Rank1Texel(texture, site.Tile, triangle.Corner);
  texels[1] = Rank1Texel(texture, site.Tile, triangle.Corner + ivec2(triangle.Sign, 0));
  texels[2] = Rank1Texel(texture, site.Tile, triangle.Corner + ivec2(0, triangle.Sign));
  weights[0] = triangle.Barycentric.x;
  weights[1] = triangle.Barycentric.y;
  weights[2] = triangle.Barycentric.z;
}
