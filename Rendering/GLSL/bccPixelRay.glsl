// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The ray of a pixel, by the pixel's place alone: VTK interpolates it between vertices of the box,
// which is not the same to the bit in a picture of fewer pixels.

uniform mat4 in_bccRay;      // (x, y, z, 1), pixels of the viewport and depth from the box's middle,
                             // to homogeneous texture coordinates
uniform mat4 in_bccToClip;   // texture coordinates to clip coordinates
uniform float in_bccNear;    // the depth where the box is cut before the camera, from its middle
uniform vec2 in_bccCorner;   // of the viewport in the window
uniform ivec2 in_bccTile;    // where a small picture begins, and the cell of its blocks that it shows
uniform ivec2 in_bccCell;
uniform int in_bccBlockSize; // of a small picture, or 0: each fragment is its own pixel
uniform int in_bccMirrored;  // whether the image's direction matrix mirrors it

float BCCWindowDepth(vec4 clip)
{
  return 0.5 * (gl_DepthRange.diff * clip.z / clip.w + gl_DepthRange.near + gl_DepthRange.far);
}

vec2 BCCPixel()
{
  if (in_bccBlockSize == 0)
  {
    return gl_FragCoord.xy - in_bccCorner;
  }
  return vec2(in_bccBlockSize * (ivec2(gl_FragCoord.xy) - in_bccTile) + in_bccCell) + 0.5;
}

// Finds where the ray enters the box, or is cut before the camera, and tells VTK.
void BCCFindPixelRay()
{
  vec2 pixel = BCCPixel();
  vec4 middle = in_bccRay * vec4(pixel, 0.0, 1.0);
  vec4 deeper = in_bccRay[2];
  vec3 point = middle.xyz / middle.w;
  vec3 direction = normalize(deeper.xyz * middle.w - middle.xyz * deeper.w);
  vec4 near = middle + in_bccNear * deeper;
  float start = dot(near.xyz / near.w - point, direction);

  bvec3 along = equal(direction, vec3(0.0));
  bvec3 forward = greaterThan(direction, vec3(0.0));
  vec3 first = (mix(in_texMax[0], in_texMin[0], forward) - point) / direction;
  vec3 last = (mix(in_texMin[0], in_texMax[0], forward) - point) / direction;
  first = mix(first, vec3(-1e20), along);
  last = mix(last, vec3(1e20), along);
  float enter = max(max(first.x, first.y), max(first.z, start));
  float leave = min(min(last.x, last.y), last.z);
  vec3 within = clamp(point, in_texMin[0], in_texMax[0]);
  if (!(enter <= leave) || any(notEqual(mix(within, point, along), within)))
  {
    discard;
  }

  ip_textureCoords = clamp(point + enter * direction, in_texMin[0], in_texMax[0]);
  ip_vertexPos = (in_textureDatasetMatrix[0] * vec4(ip_textureCoords, 1.0)).xyz;
  ip_inverseTextureDataAdjusted = in_cellToPoint[0] * in_inverseTextureDatasetMatrix[0];
  vec4 clip = in_bccToClip * vec4(ip_textureCoords, 1.0);
  float depth = BCCWindowDepth(clip);
  if (in_bccMirrored != 0 && in_bccBlockSize == 0 && enter == start)
  {
    // Of such an image VTK draws the far faces of the box as well as where it is cut.
    vec4 farClip = in_bccToClip * vec4(point + leave * direction, 1.0);
    if (abs(gl_FragCoord.z - BCCWindowDepth(farClip)) < abs(gl_FragCoord.z - depth))
    {
      discard;
    }
  }
  g_bccFragCoord = vec4(pixel + in_bccCorner, depth, 1.0 / clip.w);
}
