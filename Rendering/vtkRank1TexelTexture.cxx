// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TexelTexture.h"

#include "vtkRank1TextureInput.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkWindow.h"
#include "vtk_glew.h"

#include <algorithm>

namespace
{
constexpr float LargestHalf = 65504.0f;
constexpr vtkIdType ChunkTexels = 1 << 20; // converted at a time

/// The type that OpenGL is given texels of a type in.
int GetUploadType(int type)
{
  return type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ? type : VTK_FLOAT;
}

GLenum GetPixelType(int type)
{
  return type == VTK_UNSIGNED_CHAR ? GL_UNSIGNED_BYTE
    : type == VTK_UNSIGNED_SHORT   ? GL_UNSIGNED_SHORT
                                   : GL_FLOAT;
}

GLenum GetPixelFormat(int components)
{
  constexpr GLenum formats[] = { GL_RED, GL_RG, GL_RGB, GL_RGBA };
  return formats[components - 1];
}

GLenum GetInternalFormat(int components, int type, bool half)
{
  constexpr GLenum bytes[] = { GL_R8, GL_RG8, GL_RGB8, GL_RGBA8 };
  constexpr GLenum shorts[] = { GL_R16, GL_RG16, GL_RGB16, GL_RGBA16 };
  constexpr GLenum halves[] = { GL_R16F, GL_RG16F, GL_RGB16F, GL_RGBA16F };
  constexpr GLenum floats[] = { GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F };
  const auto& formats = type == VTK_UNSIGNED_CHAR ? bytes
    : type == VTK_UNSIGNED_SHORT                  ? shorts
    : half                                        ? halves
                                                  : floats;
  return formats[components - 1];
}

/// Puts texels that follow one another at a place of the bound texture.
void Write(const void* texels, vtkIdType first, vtkIdType count, int row, int log2Columns,
  GLenum format, GLenum type, int texelBytes)
{
  const vtkIdType columns = vtkIdType{ 1 } << log2Columns;
  const auto* from = static_cast<const unsigned char*>(texels);
  while (count > 0)
  {
    const vtkIdType column = first & (columns - 1);
    const vtkIdType rows = column == 0 ? std::max<vtkIdType>(count >> log2Columns, 1) : 1;
    const vtkIdType width = std::min(count, columns - column);
    glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(column),
      static_cast<GLint>(row + (first >> log2Columns)), static_cast<GLsizei>(width),
      static_cast<GLsizei>(rows), format, type, from);
    from += width * rows * texelBytes;
    first += width * rows;
    count -= width * rows;
  }
}
}

//------------------------------------------------------------------------------
bool vtkRank1TexelTexture::Create(
  vtkOpenGLRenderWindow* window, const vtkRank1TextureInput& input, int type, bool half)
{
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(GetInternalFormat(input.Components, type, half));
  // Texels are fetched by their places, never filtered.
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return this->Texture->Create2DFromRaw(1u << input.Log2Columns,
    static_cast<unsigned int>(input.Rows), input.Components, type, nullptr);
}

//------------------------------------------------------------------------------
void vtkRank1TexelTexture::FillLevel(
  vtkDataArray* texels, int row, int log2Columns, int type, bool half)
{
  const int components = texels->GetNumberOfComponents();
  const vtkIdType count = texels->GetNumberOfTuples();
  const GLenum format = GetPixelFormat(components);
  const GLenum pixelType = GetPixelType(type);
  const bool convert = !texels->HasStandardMemoryLayout() || texels->GetDataType() != type ||
    (half && type == VTK_FLOAT);
  if (!convert)
  {
    const int texelBytes = components * texels->GetDataTypeSize();
    Write(texels->GetVoidPointer(0), 0, count, row, log2Columns, format, pixelType, texelBytes);
    return;
  }
  vtkSmartPointer<vtkDataArray> chunk;
  chunk.TakeReference(vtkDataArray::CreateDataArray(type));
  chunk->SetNumberOfComponents(components);
  for (vtkIdType first = 0; first < count; first += ChunkTexels)
  {
    const vtkIdType size = std::min(ChunkTexels, count - first);
    chunk->SetNumberOfTuples(size);
    chunk->InsertTuples(0, size, first, texels);
    if (auto* floats = vtkFloatArray::SafeDownCast(chunk); floats && half)
    {
      for (float& value : vtk::DataArrayValueRange(floats))
      {
        value = std::max(-LargestHalf, std::min(LargestHalf, value)); // keeps NaN
      }
    }
    Write(chunk->GetVoidPointer(0), first, size, row, log2Columns, format, pixelType,
      components * chunk->GetDataTypeSize());
  }
}

//------------------------------------------------------------------------------
bool vtkRank1TexelTexture::Fill(
  vtkOpenGLRenderWindow* window, const vtkRank1TextureInput& input, bool half)
{
  if (this->Texture && this->FilledTime == input.LoadTime.GetMTime() && this->FilledHalf == half)
  {
    return true;
  }
  this->Release(window);
  const int type = GetUploadType(input.Texels[0]->GetDataType());
  if (!this->Create(window, input, type, half))
  {
    this->Release(window);
    return false;
  }
  this->Texture->Activate();
  vtkOpenGLState* state = window->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  for (std::size_t level = 0; level < input.Texels.size(); ++level)
  {
    this->FillLevel(input.Texels[level], input.FirstRows[level], input.Log2Columns, type, half);
  }
  this->Texture->Deactivate();
  this->FilledTime = input.LoadTime.GetMTime();
  this->FilledHalf = half;
  this->FillTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkRank1TexelTexture::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
