// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCProgressiveFrame
 * @brief   the rays of one volume in one viewport that have been traced so far
 *
 * The viewport is cut into blocks of s x s pixels. Each pass traces one pixel of every block, in
 * the order of a Bayer pattern, into a small picture of one pixel a block. The small pictures of
 * all passes lie beside each other in one texture of floats, those of the cells (x, y) of the
 * blocks in s columns and s rows; a second texture holds depths, of the surface where one writes
 * them and else of where the ray enters. Where a ray was discarded alpha is -1.
 *
 * A pass goes StartTracing(), while VTK draws the volume by a program of bccPixelRay.glsl and
 * bccSmallPicture.glsl, and Finish(), which draws VTK's box over the viewport and colours each
 * pixel by its ray, or by the nearest that has been traced. The first pass, which is all that a
 * moving camera shows, is drawn as one point a block.
 */

#ifndef vtkBCCProgressiveFrame_h
#define vtkBCCProgressiveFrame_h

#include "BayerPattern.h"
#include "vtkBCCDepthWatch.h"
#include "vtkBravaisABINamespace.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;

class vtkBCCProgressiveFrame
{
public:
  vtkBCCProgressiveFrame();
  ~vtkBCCProgressiveFrame();
  vtkBCCProgressiveFrame(const vtkBCCProgressiveFrame&) = delete;
  void operator=(const vtkBCCProgressiveFrame&) = delete;

  /// What it has to be made anew for.
  struct Layout
  {
    std::array<int, 4> Viewport; ///< x, y, width and height
    int Log2BlockSize;
    bool Depth;
    bool operator==(const Layout& other) const;
  };

  /// Starts anew if layout, depths or anything in the state are not as they were at the last call.
  /// The window has to be current, its framebuffer bound and its viewport set.
  void Prepare(vtkOpenGLRenderWindow* window, const Layout& layout, std::vector<double> state);

  /// Directs what is drawn by the program to this pass's small picture, or nowhere if all is
  /// traced. The box lies within bounds of pixels: x from 0 to 1 and y from 2 to 3.
  void StartTracing(vtkShaderProgram* program, const std::array<double, 4>& bounds);

  /// Has VTK's box drawn by a program of the vertex shader by which it is always drawn.
  using Draw = std::function<void(vtkShaderProgram*)>;

  /// Ends the pass and shows what is traced, if it was started: VTK may have found that there is
  /// nothing to draw. Whether the picture is complete.
  bool Finish(const Draw& drawBox);

private:
  bool IsComplete() const { return this->Passes == this->Pattern->GetNumberOfCells(); }
  void Allocate();
  void UpdateSteps();
  vtkShaderProgram* GetShowProgram(const std::string& vertex, const std::string& fragment);
  void Show(const Draw& drawBox);
  void ShowFirst();
  void ShowNearest(const Draw& drawBox);
  std::array<int, 2> GetSmallSize() const;

  struct TraceTarget;
  std::unique_ptr<TraceTarget> Target;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  Layout Current{ { { 0, 0, 0, 0 } }, 0, false };
  std::vector<double> State;
  std::optional<bravais::BayerPattern> Pattern;
  std::int64_t Passes = 0;
  std::string VertexShader;
  bool Blend = false;

  std::unique_ptr<vtkBCCDepthWatch> Watch;
  vtkSmartPointer<vtkTextureObject> Steps;   // from each cell of a block to the nearest traced one
  std::int64_t StepsPasses = 0;              // for so many passes
  vtkNew<vtkOpenGLVertexArrayObject> Points; // without attributes
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkSmartPointer<vtkTextureObject> Depths;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Small;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCProgressiveFrame.h
