// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// Shows what has been traced so far, on VTK's box: the pixel's own ray, or the nearest that was
// traced. The small pictures of the cells of a block lie beside each other in one texture.

//VTK::Output::Dec

uniform sampler2D in_bccTraced;
#ifdef BCC_DEPTH
uniform sampler2D in_bccTracedDepth;
uniform sampler2D in_depthSampler; // VTK's, of what is in front
#endif
uniform ivec2 in_bccCorner; // of the viewport
uniform ivec2 in_bccSize;   // its size
uniform ivec2 in_bccSmall;  // the size of a small picture
uniform int in_bccLog2BlockSize;
uniform int in_bccSteps[128]; // for each cell of a block, along x and y, to the nearest traced pixel

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - in_bccCorner;
  int last = (1 << in_bccLog2BlockSize) - 1;
  ivec2 cell = pixel & last;
  int number = 2 * ((cell.y << in_bccLog2BlockSize) + cell.x);
  ivec2 source = pixel + ivec2(in_bccSteps[number], in_bccSteps[number + 1]);
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
  float depth = texelFetch(in_bccTracedDepth, texel, 0).r;
  if (source != pixel)
  {
    // Not before what is in front of the box here, nor an opaque surface before what is in front of it.
    float front = texelFetch(in_depthSampler, pixel, 0).r;
    if (front <= gl_FragCoord.z || (front <= depth && color.a > 1.0 - 1.0 / 255.0))
    {
      discard;
    }
    depth = min(depth, front);
  }
  gl_FragDepth = depth;
#endif
  gl_FragData[0] = color;
}
