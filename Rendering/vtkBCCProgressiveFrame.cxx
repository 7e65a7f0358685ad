// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCProgressiveFrame.h"

#include "BayerFill.h"
#include "bccShowFirstPoints_glsl.h"
#include "bccShowFirst_glsl.h"
#include "bccShowTraced_glsl.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <algorithm>
#include <tuple>
#include <utility>

/// OpenGL's state while a small picture is traced. VTK has changed blending before, and restores it
/// in its own way before this ends.
struct vtkBCCProgressiveFrame::TraceTarget
{
  explicit TraceTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , Scissor(state)
    , ClearColor(state)
  {
    state->PushDrawFramebufferBinding();
  }
  ~TraceTarget() { this->State->PopDrawFramebufferBinding(); }
  TraceTarget(const TraceTarget&) = delete;
  void operator=(const TraceTarget&) = delete;

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
};

vtkBCCProgressiveFrame::vtkBCCProgressiveFrame() = default;
vtkBCCProgressiveFrame::~vtkBCCProgressiveFrame() = default;

//------------------------------------------------------------------------------
bool vtkBCCProgressiveFrame::Layout::operator==(const Layout& other) const
{
  return std::tie(this->Viewport, this->Log2BlockSize, this->Depth) ==
    std::tie(other.Viewport, other.Log2BlockSize, other.Depth);
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkBCCProgressiveFrame::GetSmallSize() const
{
  const int block = 1 << this->Current.Log2BlockSize;
  return { (this->Current.Viewport[2] + block - 1) / block,
    (this->Current.Viewport[3] + block - 1) / block };
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::Allocate()
{
  const int block = 1 << this->Current.Log2BlockSize;
  const auto small = this->GetSmallSize();
  const auto width = static_cast<unsigned int>(block * small[0]);
  const auto height = static_cast<unsigned int>(block * small[1]);
  this->Small = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Small->SetContext(this->Window);
  vtkOpenGLState* state = this->Window->GetState();
  state->PushDrawFramebufferBinding();
  this->Small->Bind(GL_DRAW_FRAMEBUFFER);
  const auto attach = [&](unsigned int place, int components)
  {
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(this->Window);
    texture->Allocate2D(width, height, components, VTK_FLOAT);
    this->Small->AddColorAttachment(place, texture);
    return texture;
  };
  this->Colors = attach(0, 4);
  this->Depths = attach(1, 1);
  this->Small->ActivateDrawBuffers(2);
  state->PopDrawFramebufferBinding();
  this->Watch = std::make_unique<vtkBCCDepthWatch>(
    this->Window, this->Current.Viewport[2], this->Current.Viewport[3]);
  this->Pattern = bravais::BayerPattern::Create(2, this->Current.Log2BlockSize);
  this->Steps = vtkSmartPointer<vtkTextureObject>::New();
  this->Steps->SetContext(this->Window);
  this->StepsPasses = 0;
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::Prepare(
  vtkOpenGLRenderWindow* window, const Layout& layout, std::vector<double> state)
{
  this->Target.reset();
  this->Blend = window->GetState()->GetEnumState(GL_BLEND);
  const bool anew = this->Window != window || !(this->Current == layout) || !this->Small;
  if (anew)
  {
    this->Window = window;
    this->Current = layout;
    this->Allocate();
  }
  this->Watch->Copy(layout.Viewport[0], layout.Viewport[1]);
  if (anew || this->State != state || this->Watch->HasChanged())
  {
    this->State = std::move(state);
    this->Passes = 0;
  }
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::StartTracing(
  vtkShaderProgram* program, const std::array<double, 4>& bounds)
{
  this->VertexShader = program->GetVertexShader()->GetSource();
  vtkOpenGLState* state = this->Window->GetState();
  this->Target = std::make_unique<TraceTarget>(state);
  this->Small->Bind(GL_DRAW_FRAMEBUFFER);
  this->Small->ActivateDrawBuffers(2);
  if (this->IsComplete())
  {
    state->vtkglViewport(0, 0, 0, 0);
    return;
  }
  const auto small = this->GetSmallSize();
  const glm::ivec3 cell = this->Pattern->GetCell(this->Passes);
  const int tile[4] = { cell.x * small[0], cell.y * small[1], cell.x, cell.y };
  state->vtkglViewport(tile[0], tile[1], small[0], small[1]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(tile[0], tile[1], small[0], small[1]);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, -1.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglDisable(GL_BLEND);

  // Only where the box is.
  int part[4];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double block = 1 << this->Current.Log2BlockSize;
    const int low = std::max(static_cast<int>(bounds[2 * axis] / block) - 1, 0);
    const int high = std::min(static_cast<int>(bounds[2 * axis + 1] / block) + 2, small[axis]);
    part[axis] = tile[axis] + low;
    part[axis + 2] = std::max(high - low, 0);
  }
  state->vtkglScissor(part[0], part[1], part[2], part[3]);
  program->SetUniformi("in_bccBlockSize", 1 << this->Current.Log2BlockSize);
  program->SetUniform2i("in_bccTile", tile);
  program->SetUniform2i("in_bccCell", tile + 2);
}

//------------------------------------------------------------------------------
bool vtkBCCProgressiveFrame::Finish(const Draw& drawBox)
{
  if (!this->Target)
  {
    return true;
  }
  this->Target.reset();
  this->Window->GetState()->SetEnumState(GL_BLEND, this->Blend);
  this->Passes += this->IsComplete() ? 0 : 1;
  this->Show(drawBox);
  return this->IsComplete();
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::UpdateSteps()
{
  if (this->StepsPasses == this->Passes)
  {
    return;
  }
  std::vector<float> steps;
  for (const glm::ivec2& step : bravais::GetNearestFirstCells(*this->Pattern, this->Passes))
  {
    steps.insert(steps.end(), { static_cast<float>(step.x), static_cast<float>(step.y) });
  }
  const auto side = 1u << this->Current.Log2BlockSize;
  this->Steps->Create2DFromRaw(side, side, 2, VTK_FLOAT, steps.data());
  this->StepsPasses = this->Passes;
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::Show(const Draw& drawBox)
{
  // As vtkVolumeStateRAII, which VTK's ray caster draws in.
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  vtkOpenGLState::ScopedglDepthFunc test(state);
  int cullFace = GL_BACK;
  state->vtkglGetIntegerv(GL_CULL_FACE_MODE, &cullFace);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(GL_BACK);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDepthMask(this->Current.Depth ? GL_TRUE : GL_FALSE);
  // Rays of other pixels may not know of what is in front here. A pixel's own has made the test.
  state->vtkglDepthFunc(this->Current.Depth && this->IsComplete() ? GL_ALWAYS : GL_LEQUAL);
  this->Colors->Activate();
  this->Depths->Activate();
  if (this->Passes == 1)
  {
    this->ShowFirst();
  }
  else
  {
    this->ShowNearest(drawBox);
  }

  this->Depths->Deactivate();
  this->Colors->Deactivate();
  state->vtkglCullFace(static_cast<unsigned int>(cullFace));
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkBCCProgressiveFrame::GetShowProgram(
  const std::string& vertex, const std::string& fragment)
{
  vtkShaderProgram* program =
    this->Window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (program)
  {
    program->SetUniform2i("in_bccSmall", this->GetSmallSize().data());
    program->SetUniformi("in_bccTraced", this->Colors->GetTextureUnit());
    program->SetUniformi("in_bccTracedDepth", this->Depths->GetTextureUnit());
  }
  return program;
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::ShowFirst()
{
  vtkShaderProgram* program = this->GetShowProgram(bccShowFirstPoints_glsl, bccShowFirst_glsl);
  if (!program)
  {
    return;
  }
  const int block = 1 << this->Current.Log2BlockSize;
  program->SetUniformi("in_bccBlockSize", block);
  const auto& viewport = this->Current.Viewport;
  const auto small = this->GetSmallSize();
  const int columns = small[0] + 1;
  const int rows = small[1] + 1;

  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglViewport wide(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissor(state);
  state->vtkglViewport(viewport[0], viewport[1], block * columns, block * rows);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  state->vtkglPointSize(static_cast<float>(block));
  this->Points->Bind();
  glDrawArrays(GL_POINTS, 0, columns * rows);
  this->Points->Release();
  state->vtkglPointSize(1.0f);
}

//------------------------------------------------------------------------------
void vtkBCCProgressiveFrame::ShowNearest(const Draw& drawBox)
{
  std::string fragment = bccShowTraced_glsl;
  if (this->Current.Depth)
  {
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Output::Dec", "#define BCC_DEPTH\n//VTK::Output::Dec");
  }
  vtkShaderProgram* program = this->GetShowProgram(this->VertexShader, fragment);
  if (!program)
  {
    return;
  }
  this->UpdateSteps();
  this->Steps->Activate();
  program->SetUniformi("in_bccSteps", this->Steps->GetTextureUnit());
  program->SetUniformi("in_bccLog2BlockSize", this->Current.Log2BlockSize);
  program->SetUniform2i("in_bccCorner", this->Current.Viewport.data());
  program->SetUniform2i("in_bccSize", this->Current.Viewport.data() + 2);
  drawBox(program);
  this->Steps->Deactivate();
}
