// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// The vertex shader of the first pass: vertex number n is a point as large as a block, at the depth
// that was traced, over the pixels that are nearest to the traced one. A column and a row more than
// there are blocks cover what is left at the border.

uniform sampler2D in_bccTraced;
uniform sampler2D in_bccTracedDepth;
uniform ivec2 in_bccSmall; // the size of a small picture
uniform int in_bccBlockSize;

flat out vec4 color;

void main()
{
  ivec2 points = in_bccSmall + 1;
  ivec2 block = ivec2(gl_VertexID % points.x, gl_VertexID / points.x);
  ivec2 texel = min(block, in_bccSmall - 1);
  color = texelFetch(in_bccTraced, texel, 0);
  vec2 middle = vec2(in_bccBlockSize * block + 1) / vec2(in_bccBlockSize * points);
  float depth = texelFetch(in_bccTracedDepth, texel, 0).r;
  bool discarded = color.a < 0.0;
  gl_Position = vec4(2.0 * middle - 1.0, discarded ? 2.0 : 2.0 * depth - 1.0, 1.0);
}
