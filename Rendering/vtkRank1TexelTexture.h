// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TexelTexture
 * @brief   the texels of a vtkRank1TextureInput in a texture of the GPU
 *
 * Arrays of bytes, 16-bit unsigned integers and floats are handed to OpenGL where they lie; others
 * are converted some rows at a time.
 */

#ifndef vtkRank1TexelTexture_h
#define vtkRank1TexelTexture_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkRank1TextureInput;
class vtkTextureObject;
class vtkWindow;

class VTKBRAVAIS_EXPORT vtkRank1TexelTexture
{
public:
  /// Fills the texture unless it is filled with these texels already. False where OpenGL fails.
  bool Fill(vtkOpenGLRenderWindow* window, const vtkRank1TextureInput& input, bool half);
  void Release(vtkWindow* window);

  vtkSmartPointer<vtkTextureObject> Texture;
  vtkTimeStamp FillTime;

private:
  bool Create(
    vtkOpenGLRenderWindow* window, const vtkRank1TextureInput& input, int type, bool half);
  void FillLevel(vtkDataArray* texels, int row, int log2Columns, int type, bool half);

  vtkMTimeType FilledTime = 0; // of the data
  bool FilledHalf = false;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkRank1TexelTexture.h
