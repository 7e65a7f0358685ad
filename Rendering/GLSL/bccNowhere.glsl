//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The vertex shader in the place of one that does not compile: beyond the view. VTK finds the
// attribute that it is to use later, with one that does.
in vec3 in_vertexPos;

void main()
{
  gl_Position = vec4(2.0 + abs(in_vertexPos), 1.0);
}
