// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec

// The geometry shader of a small picture: instead of VTK's box one rectangle covers all of it, and
// each fragment finds out by itself whether its ray meets the box.

layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;

void main()
{
  if (gl_PrimitiveIDIn == 0)
  {
    for (int i = 0; i < 4; ++i)
    {
      gl_Position = vec4(2 * (i & 1) - 1, (i & 2) - 1, 0.0, 1.0);
      EmitVertex();
    }
    EndPrimitive();
  }
}
