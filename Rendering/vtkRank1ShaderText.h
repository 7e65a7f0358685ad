// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1ShaderText
 * @brief   the GLSL of textures on rank-1 lattices, put together from Rendering/GLSL
 */

#ifndef vtkRank1ShaderText_h
#define vtkRank1ShaderText_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRank1TextureInput;

class VTKBRAVAIS_EXPORT vtkRank1ShaderText
{
public:
  /// The functions of a texture's look-up, up to `vec4 Rank1Color(vec2 uv, vec4 footprint)`.
  static std::string GetLookUp(
    const vtkRank1TextureInput& input, int interpolation, int levelFilter);

  /// Puts the look-up into the shaders of vtkOpenGLPolyDataMapper, in which the attribute
  /// `rank1TCoord` is the place in the picture.
  static void ReplaceVertex(std::string& source);
  static void ReplaceGeometry(std::string& source);
  static void ReplaceFragment(std::string& source, const std::string& lookUp);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkRank1ShaderText.h
