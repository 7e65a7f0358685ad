// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCDepthWatch
 * @brief   tells whether what is in front of a volume has changed
 *
 * Rays end at the depths that opaque geometry has left in the depth buffer. Here they are copied,
 * and compared with those of the frame before on the GPU; so it does not matter what props there
 * are, or whether they tell that they have changed.
 */

#ifndef vtkBCCDepthWatch_h
#define vtkBCCDepthWatch_h

#include "vtkBravaisABINamespace.h"
#include "vtkNew.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

class vtkBCCDepthWatch
{
public:
  /// For viewports of this size in the window, which has to be current.
  vtkBCCDepthWatch(vtkOpenGLRenderWindow* window, int width, int height);
  ~vtkBCCDepthWatch();
  vtkBCCDepthWatch(const vtkBCCDepthWatch&) = delete;
  void operator=(const vtkBCCDepthWatch&) = delete;

  /// Copies the depths of the framebuffer that is read from. `x` and `y` are the viewport's corner.
  void Copy(int x, int y);

  /// Whether the last two copies differ.
  bool HasChanged();

private:
  vtkOpenGLRenderWindow* Window;
  int Width;
  int Height;
  vtkNew<vtkTextureObject> Depths[2];
  vtkNew<vtkTextureObject> Color; // Framebuffers should have one.
  vtkNew<vtkOpenGLFramebufferObject> Copies[2];
  vtkNew<vtkOpenGLFramebufferObject> Comparison;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  int Latest = 0;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCDepthWatch.h
