// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCBrickTexture
 * @brief   what vtkBCCVolumeMapper's shader knows of empty space
 *
 * A buffer of bytes, one for each brick of the volume (vtkBCCBrickMarks), made anew when the
 * coefficients, what is seen of them, or the window change.
 */

#ifndef vtkBCCBrickTexture_h
#define vtkBCCBrickTexture_h

#include "vtkBravaisABINamespace.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <tuple>
#include <vector>

namespace bravais
{
class BCCBricks;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkOpenGLBufferObject;
class vtkOpenGLGPUVolumeRayCastMapper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkVolumeProperty;
class vtkWindow;

class vtkBCCBrickTexture
{
public:
  vtkBCCBrickTexture();
  ~vtkBCCBrickTexture();

  /// What tells a brick that holds nothing.
  enum Rule
  {
    Nothing, ///< no brick does
    Opacity,
    IsoValues,
    Maximum,
    Minimum
  };

  /// The rule for a volume's blend mode, mask and components.
  static Rule FindRule(
    vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, int components, bool refined);

  /// Sets the program's sampler in_bccBricks and how many there are, after VTK has made the
  /// volume's texture and tables ready. `time` is that of the bricks; values are multiplied by the
  /// normalizer.
  bool Activate(vtkShaderProgram* program, vtkOpenGLGPUVolumeRayCastMapper* mapper,
    vtkVolumeProperty* property, vtkOpenGLRenderWindow* window, Rule rule,
    const bravais::BCCBricks& bricks, vtkMTimeType time, float normalizer);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Bytes on the GPU.
  vtkIdType GetSize() const { return this->Size; }

private:
  bool Fill(vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, Rule rule,
    const bravais::BCCBricks& bricks, float normalizer);

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  vtkIdType Size = 0;
  std::tuple<Rule, vtkMTimeType, vtkMTimeType, vtkMTimeType, float, std::vector<float>> Filled;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCBrickTexture.h
