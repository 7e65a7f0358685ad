//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// The fragment shader in the place of one that does not compile.
void main()
{
  gl_FragData[0] = vec4(0.0);
  discard;
}
