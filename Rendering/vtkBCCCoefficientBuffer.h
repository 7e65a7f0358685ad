// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCCoefficientBuffer
 * @brief   coefficients in a buffer, for fetches without filtering
 *
 * The texels of vtkBCCCoefficientTexels as an OpenGL buffer that the shader reads by a texel's
 * number. To go from one texel to the next is one addition there, and a fetch has nothing to
 * compute from sizes: where a processor draws, one takes a third of the time of one from a 3D
 * texture.
 *
 * The texels of both cosets take turns: the even point of an index, and then the odd one, so that
 * the stencils, which need both, meet fewer cache lines. For bcc12, which takes rows of one coset,
 * the odd coset follows the even one, as in the texture.
 */

#ifndef vtkBCCCoefficientBuffer_h
#define vtkBCCCoefficientBuffer_h

#include "BCCKernel.h"
#include "vtkBravaisABINamespace.h"

#include "vtkBravaisModule.h" // For export macro
#include "vtkNew.h"

#include <glm/vec4.hpp>

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCCoefficientTexels;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class VTKBRAVAIS_EXPORT vtkBCCCoefficientBuffer
{
public:
  vtkBCCCoefficientBuffer();
  ~vtkBCCCoefficientBuffer();

  /// Whether a buffer can take the place of the 3D texture, and serves better: where a processor
  /// draws. Graphics processors keep neighbours in 3D together, and filter fetches at no cost.
  static bool IsBetter(vtkOpenGLRenderWindow* window, const vtkBCCCoefficientTexels& texels);

  /// Uploads the texels, as half floats if so asked. For bcc12 of one component a fetch takes four.
  bool Fill(vtkOpenGLRenderWindow* window, bravais::BCCKernel kernel,
    const vtkBCCCoefficientTexels& texels, bool halfFloats);
  /// Sets the program's sampler in_bccCoefficients and how its texels are numbered.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  // Texels to the next along each axis, and from the even point of an index to the odd one.
  glm::ivec4 Steps = glm::ivec4(0);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCCoefficientBuffer.h
