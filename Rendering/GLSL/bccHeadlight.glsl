// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Shading by a headlight alone, as VTK's own, which it has no more once there were other lights.

vec3 BCCHeadlight(vec3 color, int component, vec3 gradient)
{
  float size = length(gradient);
  float facing = dot(gradient, normalize(g_eyePosObj.xyz - ip_vertexPos));
  facing = size > 0.0 ? (in_twoSidedLighting ? abs(facing) : facing) / size : 0.0;
  vec3 diffuse = max(facing, 0.0) * in_diffuse[component] * in_lightDiffuseColor[0];
  return (in_ambient[component] + diffuse) * color +
    pow(facing, in_shininess[component]) * in_specular[component] * in_lightSpecularColor[0];
}
