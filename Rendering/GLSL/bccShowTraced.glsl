// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// Shows what has been traced so far, on VTK's box: the pixel's own ray, or the nearest that was
// traced. The small pictures of the cells of a block lie beside each other in one texture.

//VTK::Output::Dec

uniform sampler2D in_bccTraced;
#ifdef BCC_DEPTH
uniform sampler2D in_bccTracedDepth;
#endif
uniform ivec2 in_bccCorner; // of the viewport
uniform ivec2 in_bccSize;   // its size
uniform ivec2 in_bccSmall;  // the size of a small picture
uniform int in_bccLog2BlockSize;
uniform sampler2D in_bccSteps; // from each cell of a block to the nearest traced pixel

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - in_bccCorner;
  int last = (1 << in_bccLog2BlockSize) - 1;
  ivec2 cell = pixel & last;
  ivec2 source = pixel + ivec2(texelFetch(in_bccSteps, cell, 0).xy);
  if (any(lessThan(source, ivec2(0))) || any(greaterThanEqual(source, in_bccSize)))
  {
    source = pixel - cell; // which is traced first
  }
  ivec2 texel = (source & last) * in_bccSmall + (source >> in_bccLog2BlockSize);
  vec4 color = texelFetch(in_bccTraced, texel, 0);
  if (color.a < 0.0)
  {
    discard; // as the ray was
  }
#ifdef BCC_DEPTH
  gl_FragDepth = texelFetch(in_bccTracedDepth, texel, 0).r;
#endif
  gl_FragData[0] = color;
}
