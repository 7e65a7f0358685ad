// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderDrawing.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cmath>

std::vector<float> DrawAtPoints(vtkOpenGLRenderWindow* window, const std::string& declarations,
  const std::string& implementation, const std::vector<float>& points, int numbers,
  const std::function<void(vtkShaderProgram*)>& prepare)
{
  const std::size_t count = points.size() / numbers;
  const auto side = static_cast<int>(std::lround(std::sqrt(count)));
  std::string source = vtkOpenGLRenderUtilities::GetFullScreenQuadFragmentShaderTemplate();
  vtkShaderProgram::Substitute(
    source, "//VTK::FSQ::Decl", "uniform sampler2D points;\nvec4 point;\n" + declarations);
  // The quad has texture coordinates, which the compiler must not find to be of no use.
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Impl",
    "if (texCoord.x < 0.0) { discard; }\npoint = texture(points, texCoord);\n" + implementation);
  vtkNew<vtkTextureObject> places;
  places->SetContext(window);
  places->Create2DFromRaw(side, side, numbers, VTK_FLOAT, const_cast<float*>(points.data()));
  vtkNew<vtkTextureObject> target;
  target->SetContext(window);
  target->Allocate2D(side, side, 4, VTK_FLOAT);

  vtkNew<vtkOpenGLFramebufferObject> buffer;
  buffer->SetContext(window);
  window->GetState()->PushFramebufferBindings();
  buffer->Bind();
  buffer->AddColorAttachment(0, target);
  buffer->ActivateDrawBuffer(0);
  buffer->StartNonOrtho(side, side);
  vtkOpenGLState::ScopedglEnableDisable blend(window->GetState(), GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depth(window->GetState(), GL_DEPTH_TEST);
  window->GetState()->vtkglDisable(GL_BLEND);
  window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  vtkOpenGLQuadHelper quad(window, nullptr, source.c_str(), "");
  places->Activate();
  quad.Program->SetUniformi("points", places->GetTextureUnit());
  prepare(quad.Program);
  quad.Render();
  quad.ReleaseGraphicsResources(window);
  window->GetState()->PopFramebufferBindings();
  places->Deactivate();

  vtkPixelBufferObject* download = target->Download();
  std::vector<float> result(4 * count);
  const auto* mapped = static_cast<const float*>(download->MapPackedBuffer());
  std::copy_n(mapped, result.size(), result.begin());
  download->UnmapPackedBuffer();
  download->Delete();
  places->ReleaseGraphicsResources(window);
  target->ReleaseGraphicsResources(window);
  buffer->ReleaseGraphicsResources(window);
  return result;
}
