// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCCoefficientBuffer.h"

#include "vtkBCCCoefficientTexels.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstdint>
#include <string>

vtkBCCCoefficientBuffer::vtkBCCCoefficientBuffer() = default;
vtkBCCCoefficientBuffer::~vtkBCCCoefficientBuffer() = default;

namespace
{

// Whether OpenGL is computed by the processor.
bool IsSoftware()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkBCCCoefficientBuffer::IsBetter(
  vtkOpenGLRenderWindow* window, const vtkBCCCoefficientTexels& texels)
{
  int most = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  const std::size_t count = texels.Values.size() / texels.Components;
  // There are no buffers of three half floats.
  return texels.Components != 3 && count <= static_cast<std::size_t>(most) && IsSoftware();
}

//------------------------------------------------------------------------------
bool vtkBCCCoefficientBuffer::Fill(vtkOpenGLRenderWindow* window, bravais::BCCKernel kernel,
  const vtkBCCCoefficientTexels& texels, bool halfFloats)
{
  static const GLenum formats[2][4] = { { GL_R32F, GL_RG32F, 0, GL_RGBA32F },
    { GL_R16F, GL_RG16F, 0, GL_RGBA16F } };
  const auto type = vtkOpenGLBufferObject::TextureBuffer;
  const std::vector<float>& values = texels.Values;
  bool filled = false;
  this->Buffer->SetType(type);
  if (halfFloats)
  {
    std::vector<std::uint16_t> halves(values.size());
    std::transform(values.begin(), values.end(), halves.begin(), glm::packHalf1x16);
    filled = this->Buffer->Upload(halves, type);
  }
  else
  {
    filled = this->Buffer->Upload(values, type);
  }
  const int channels =
    kernel == bravais::BCCKernel::BCC12 && texels.Components == 1 ? 4 : texels.Components;
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(formats[halfFloats][channels - 1]);
  return filled &&
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(values.size() / channels), channels, VTK_FLOAT, this->Buffer);
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientBuffer::Activate(
  vtkShaderProgram* program, const vtkBCCCoefficientTexels& texels)
{
  this->Texture->Activate();
  program->SetUniformi("in_bccCoefficients", this->Texture->GetTextureUnit());
  const int pitch[2] = { texels.Size.x, texels.Size.x * texels.Size.y };
  program->SetUniform2i("in_bccPitch", pitch);
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientBuffer::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}
