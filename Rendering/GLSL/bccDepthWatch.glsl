// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// Leaves the pixels whose depth has changed, to be counted.

//VTK::Output::Dec

uniform sampler2D in_bccNow;
uniform sampler2D in_bccBefore;

in vec2 texCoord;

void main()
{
  if (texture2D(in_bccNow, texCoord).r == texture2D(in_bccBefore, texCoord).r)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0);
}
