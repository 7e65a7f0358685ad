// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// Shows the first pass, one point a block.

//VTK::Output::Dec

flat in vec4 color;

void main()
{
  gl_FragData[0] = color;
}
