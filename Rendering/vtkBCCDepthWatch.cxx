// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCDepthWatch.h"

#include "bccDepthWatch_glsl.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

//------------------------------------------------------------------------------
vtkBCCDepthWatch::vtkBCCDepthWatch(vtkOpenGLRenderWindow* window, int width, int height)
  : Window(window)
  , Width(width)
  , Height(height)
{
  this->Color->SetContext(window);
  this->Color->Allocate2D(width, height, 1, VTK_UNSIGNED_CHAR);
  vtkOpenGLState* state = window->GetState();
  state->PushDrawFramebufferBinding();
  for (int i = 0; i < 2; ++i)
  {
    // Depths can only be copied to their own format, which VTK's ray caster chooses like this.
    this->Depths[i]->SetContext(window);
    if (window->GetStencilCapable())
    {
      this->Depths[i]->AllocateDepthStencil(width, height);
    }
    else
    {
      this->Depths[i]->AllocateDepth(width, height, vtkTextureObject::Fixed32);
    }
    this->Copies[i]->SetContext(window);
    this->Copies[i]->Bind(GL_DRAW_FRAMEBUFFER);
    this->Copies[i]->AddDepthAttachment(this->Depths[i]);
    this->Copies[i]->AddColorAttachment(0, this->Color);
  }
  this->Comparison->SetContext(window);
  this->Comparison->Bind(GL_DRAW_FRAMEBUFFER);
  this->Comparison->AddColorAttachment(0, this->Color);
  this->Comparison->ActivateDrawBuffers(1);
  state->PopDrawFramebufferBinding();
}

//------------------------------------------------------------------------------
vtkBCCDepthWatch::~vtkBCCDepthWatch() = default;

//------------------------------------------------------------------------------
void vtkBCCDepthWatch::Copy(int x, int y)
{
  this->Latest = 1 - this->Latest;
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST); // which a blit obeys
  state->PushDrawFramebufferBinding();
  this->Copies[this->Latest]->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglBlitFramebuffer(x, y, x + this->Width, y + this->Height, 0, 0, this->Width,
    this->Height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopDrawFramebufferBinding();
}

//------------------------------------------------------------------------------
bool vtkBCCDepthWatch::HasChanged()
{
  if (!this->Quad)
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(this->Window, nullptr, bccDepthWatch_glsl, nullptr);
  }
  else
  {
    this->Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->PushDrawFramebufferBinding();
  this->Comparison->Bind(GL_DRAW_FRAMEBUFFER);
  const char* const names[] = { "in_bccNow", "in_bccBefore" };
  for (int i = 0; i < 2; ++i)
  {
    vtkTextureObject* texture = this->Depths[i == 0 ? this->Latest : 1 - this->Latest];
    texture->Activate();
    this->Quad->Program->SetUniformi(names[i], texture->GetTextureUnit());
  }

  GLuint query = 0;
  GLuint count = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  this->Quad->Render();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);

  this->Depths[0]->Deactivate();
  this->Depths[1]->Deactivate();
  state->PopDrawFramebufferBinding();
  return count > 0;
}
