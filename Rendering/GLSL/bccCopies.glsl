// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Copies, as bccVolume has them, of uniforms that VTK's text names for each sample. They take their
// place in all text that follows.

#ifdef BCC_BUFFER
vec4 g_bccVolumeScale[1] = vec4[1](in_volume_scale[0]);
vec4 g_bccVolumeBias[1] = vec4[1](in_volume_bias[0]);
vec2 g_bccScalarsRange[4] =
  vec2[4](in_scalarsRange[0], in_scalarsRange[1], in_scalarsRange[2], in_scalarsRange[3]);
vec3 g_bccAmbient[4] = vec3[4](in_ambient[0], in_ambient[1], in_ambient[2], in_ambient[3]);
vec3 g_bccDiffuse[4] = vec3[4](in_diffuse[0], in_diffuse[1], in_diffuse[2], in_diffuse[3]);
vec3 g_bccSpecular[4] = vec3[4](in_specular[0], in_specular[1], in_specular[2], in_specular[3]);
float g_bccShininess[4] =
  float[4](in_shininess[0], in_shininess[1], in_shininess[2], in_shininess[3]);
#define in_volume_scale g_bccVolumeScale
#define in_volume_bias g_bccVolumeBias
#define in_scalarsRange g_bccScalarsRange
#define in_ambient g_bccAmbient
#define in_diffuse g_bccDiffuse
#define in_specular g_bccSpecular
#define in_shininess g_bccShininess
#endif
