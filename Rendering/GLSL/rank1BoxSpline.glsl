// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Which texels a point takes, and with what weights, by the three-direction quartic box-spline. The
// twins are in Module/Core/Rank1BoxSpline.h.

void EvaluateRank1BoxSpline(vec3 barycentric, out float weights[12])
{
  vec3 p = barycentric;
  vec3 q = p.yzx;
  vec3 r = p.zxy;
  vec3 p2 = p * p;
  vec3 p4 = p2 * p2;
  vec3 q2 = q * q;
  vec3 r2 = r * r;
  vec3 qr = q * r;
  vec3 q4r4 = q2 * q2 + r2 * r2;
  vec3 vertex = 6.0 * p4 + 24.0 * p2 * p * (q + r) + p2 * (24.0 * (q2 + r2) + 60.0 * qr) +
    p * (8.0 * (q2 * q + r2 * r) + 36.0 * qr * (q + r)) + q4r4 + 6.0 * qr * (q2 + r2) +
    12.0 * qr * qr;
  vec3 across = q4r4 + 6.0 * qr * (q2 + r2) + 12.0 * qr * qr +
    p * (2.0 * (q2 * q + r2 * r) + 6.0 * qr * (q + r));
  vec3 awayFromNext = p4 + 2.0 * p2 * p * r;
  vec3 awayFromLast = p4 + 2.0 * p2 * p * q;
  for (int i = 0; i < 3; ++i)
  {
    weights[i] = vertex[i] * (1.0 / 12.0);
    weights[3 + i] = across[i] * (1.0 / 12.0);
    weights[6 + 2 * i] = awayFromNext[i] * (1.0 / 12.0);
    weights[7 + 2 * i] = awayFromLast[i] * (1.0 / 12.0);
  }
}

void FindRank1BoxSpline(Rank1Texture texture, vec2 uv, out int texels[12], out float weights[12])
{
  const ivec2 stencil[12] = ivec2[12](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1),
    ivec2(-1, 1), ivec2(1, -1), ivec2(-1, 0), ivec2(0, -1), ivec2(2, -1), ivec2(2, 0), ivec2(0, 2),
    ivec2(-1, 2));
  Rank1Site site = FindRank1Site(texture, uv);
  Rank1Triangle triangle = FindRank1Triangle(site);
  EvaluateRank1BoxSpline(triangle.Barycentric, weights);
  for (int i = 0; i < 12; ++i)
  {
    texels[i] = Rank1Texel(texture, site.Tile, triangle.Corner + triangle.Sign * stencil[i]);
  }
}
