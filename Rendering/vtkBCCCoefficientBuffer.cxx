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
#include <cstddef>
#include <cstdint>
#include <string>

vtkBCCCoefficientBuffer::vtkBCCCoefficientBuffer() = default;
vtkBCCCoefficientBuffer::~vtkBCCCoefficientBuffer() = default;

namespace
{

// How many cosets' texels take turns: both, or one for bcc12, whose rows are fetched as they lie.
int GetTurns(bravais::BCCKernel kernel)
{
  return kernel == bravais::BCCKernel::BCC12 ? 1 : 2;
}

// Whether OpenGL is computed by the processor.
bool IsSoftware()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}

// Uploads the texels a slice of each coset in turn, so that no second copy of all is made.
template <class T, class Convert>
void UploadTexels(const vtkBCCCoefficientTexels& texels, int turns, Convert convert)
{
  const auto slice = static_cast<std::size_t>(texels.Size.x) * texels.Size.y * texels.Components;
  const int blocks = texels.Size.z / turns;
  std::vector<T> block(turns * slice);
  const auto bytes = static_cast<GLsizeiptr>(sizeof(T) * block.size());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(sizeof(T) * texels.Values.size()),
    nullptr, GL_STATIC_DRAW);
  for (int b = 0; b < blocks; ++b)
  {
    for (int coset = 0; coset < turns; ++coset)
    {
      const std::size_t from = (b + static_cast<std::size_t>(coset) * blocks) * slice;
      for (std::size_t n = 0; n < slice; n += texels.Components)
      {
        const auto texel = texels.Values.begin() + static_cast<std::ptrdiff_t>(from + n);
        std::transform(texel, texel + texels.Components,
          block.begin() + static_cast<std::ptrdiff_t>(turns * n + coset * texels.Components),
          convert);
      }
    }
    glBufferSubData(GL_TEXTURE_BUFFER, b * bytes, bytes, block.data());
  }
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
  if (!this->Buffer->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer) || !this->Buffer->Bind())
  {
    return false;
  }
  const int turns = GetTurns(kernel);
  if (halfFloats)
  {
    UploadTexels<std::uint16_t>(texels, turns, glm::packHalf1x16);
  }
  else
  {
    UploadTexels<float>(texels, turns, [](float value) { return value; });
  }
  const int pitch = turns * texels.Size.x;
  const int layer = pitch * texels.Size.y;
  this->Steps = { turns, pitch, layer, turns == 2 ? 1 : layer * (texels.Size.z / 2) };
  const int channels =
    kernel == bravais::BCCKernel::BCC12 && texels.Components == 1 ? 4 : texels.Components;
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(formats[halfFloats][channels - 1]);
  return this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(texels.Values.size() / channels), channels, VTK_FLOAT, this->Buffer);
}

//------------------------------------------------------------------------------
void vtkBCCCoefficientBuffer::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi("in_bccCoefficients", this->Texture->GetTextureUnit());
  program->SetUniform1iv("in_bccTexelSteps", 4, &this->Steps.x);
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
