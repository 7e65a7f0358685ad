// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeShaderStage.h"

#include "vtkBCCProgressiveFrame.h"
#include "vtkBCCShaderEdits.h"
#include "vtkBCCVolumeInput.h"
#include "vtkBCCVolumeMask.h"
#include "vtkBCCVolumeRays.h"

#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeTexture.h"
#include "vtk_glew.h"

vtkStandardNewMacro(vtkBCCVolumeShaderStage);

struct vtkBCCVolumeShaderStage::DepthState
{
  explicit DepthState(vtkOpenGLState* state)
    : State(state)
    , Mask(state)
    , Function(state)
  {
  }
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglDepthMask Mask;
  vtkOpenGLState::ScopedglDepthFunc Function;
};

vtkBCCVolumeShaderStage::vtkBCCVolumeShaderStage() = default;
vtkBCCVolumeShaderStage::~vtkBCCVolumeShaderStage() = default;

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::Begin(vtkRenderer* renderer, vtkVolume* volume,
  const vtkBCCShaderOptions& options, vtkBCCVolumeInput& input)
{
  if (!(options == this->Current))
  {
    this->Current = options;
    this->Modified(); // has VTK make the shader anew
  }
  this->Renderer = renderer;
  this->Volume = volume;
  this->Input = &input;
  const bool colors = options.Components == 4 && !volume->GetProperty()->GetIndependentComponents();
  this->Normalizer = colors ? input.GetNormalizer() : 1.0f;
  if (options.WriteDepth)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    this->Saved = std::make_unique<DepthState>(window->GetState());
  }

  vtkInformation* keys = volume->GetPropertyKeys();
  if (!keys)
  {
    keys = vtkInformation::New();
    volume->SetPropertyKeys(keys);
    keys->FastDelete();
  }
  // VTK asks the last pass how many buffers are drawn to.
  this->ActiveDrawBuffers = 1;
  if (const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses()))
  {
    auto* last =
      static_cast<vtkOpenGLRenderPass*>(keys->Get(vtkOpenGLRenderPass::RenderPasses(), count - 1));
    this->ActiveDrawBuffers = last->GetActiveDrawBuffers();
  }
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::End()
{
  vtkInformation* keys = this->Volume->GetPropertyKeys();
  keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
  if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
  {
    keys->Remove(vtkOpenGLRenderPass::RenderPasses());
  }
  this->Saved.reset();
  this->Bricks.Deactivate();
  this->Coefficients.Deactivate();
  this->Renderer = nullptr;
  this->Volume = nullptr;
  this->Input = nullptr;
  this->Target = nullptr;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Bricks.ReleaseGraphicsResources(window);
  this->Coefficients.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeShaderStage::PreReplaceShaderValues(
  std::string&, std::string& geometry, std::string& fragment, vtkAbstractMapper* mapper, vtkProp*)
{
  vtkBCCShaderEdits::EditBefore(this->Current, vtkGPUVolumeRayCastMapper::SafeDownCast(mapper),
    this->Volume->GetProperty(), geometry, fragment);
  if (vtkHardwareSelector* selector = this->Renderer->GetSelector())
  {
    vtkBCCShaderEdits::EditPicking(this->Current, selector->GetCurrentPass(), fragment);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeShaderStage::PostReplaceShaderValues(
  std::string& vertex, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*)
{
  const bool found =
    vtkBCCShaderEdits::EditAfter(this->Current, this->Renderer->GetSelector() != nullptr, fragment);
  this->Check.Check(this->Volume, vertex, fragment);
  return found;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeShaderStage::FillTexture(vtkVolumeTexture* texture)
{
  vtkTextureObject* object = texture->GetCurrentBlock()->TextureObject;
  bool filled = true;
  if (this->Filled != texture || this->FilledTime != texture->UploadTime.GetMTime())
  {
    vtkBCCCoefficientTexels& texels = this->Input->Texels;
    glm::ivec3 size = texels.Size;
    if (this->Current.Buffer)
    {
      filled = this->Coefficients.Fill(
        vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow()),
        this->Current.Kernel, texels, this->Current.HalfFloats);
      size = glm::ivec3(1); // of what VTK binds
    }
    else
    {
      this->Coefficients.ReleaseGraphicsResources(this->Renderer->GetRenderWindow());
    }
    static const GLenum formats[2][4] = { { GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F },
      { GL_R16F, GL_RG16F, GL_RGB16F, GL_RGBA16F } };
    object->SetInternalFormat(formats[this->Current.HalfFloats][texels.Components - 1]);
    filled = filled &&
      object->Create3DFromRaw(
        size.x, size.y, size.z, texels.Components, VTK_FLOAT, texels.Values.data());
    this->Filled = filled ? texture : nullptr;
    this->FilledTime = texture->UploadTime.GetMTime();
  }
  const int filter = this->Current.Kernel == bravais::BCCKernel::BCC12 ? vtkTextureObject::Linear
                                                                       : vtkTextureObject::Nearest;
  object->SetMagnificationFilter(filter);
  object->SetMinificationFilter(filter);
  return filled;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::SetPieceUniforms(vtkShaderProgram* program)
{
  const vtkBCCVolumePiece& piece = *this->Input->Piece;
  int texel[3];
  float origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    texel[axis] = vtkBCCCoefficientTexels::Halo - piece.Base[axis] / 2;
    origin[axis] = static_cast<float>(piece.Base[axis]);
  }
  program->SetUniform1iv("in_bccOriginTexel", 3, texel);
  if (program->IsUniformUsed("in_bccBrickOrigin"))
  {
    program->SetUniform3f("in_bccBrickOrigin", origin);
  }
  if (program->IsUniformUsed("in_bccHeldLow"))
  {
    const vtkBCCVolumeFrame held = this->Input->GetHeldFrame();
    program->SetUniform3f("in_bccHeldLow", held.Low);
    program->SetUniform3f("in_bccHeldHigh", held.High);
  }
  if (this->Current.Piece)
  {
    program->SetUniform3f("in_bccPieceLow", piece.Low);
    program->SetUniform3f("in_bccPieceHigh", piece.High);
  }
}

//------------------------------------------------------------------------------
// VTK divides by one cell less than there are.
void vtkBCCVolumeShaderStage::SetCells(vtkVolumeTexture* texture) const
{
  const vtkBCCVolumeFrame& frame = *this->Input->Frame;
  auto* block = texture->GetCurrentBlock();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = frame.Extent[2 * axis + 1] - frame.Extent[2 * axis] + 1;
    block->CellStep[axis] = 1.0f / static_cast<float>(axis == 2 ? points - 1 : points);
    texture->CellSpacing[axis] = static_cast<float>(frame.Spacing[axis]);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::SetRayUniforms(
  vtkShaderProgram* program, vtkMatrix4x4* textureToDataset)
{
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkBCCVolumeRays rays;
  rays.Compute(this->Renderer, viewport, textureToDataset, this->Volume->GetMatrix());
  rays.SetUniforms(program);
  program->SetUniformi("in_bccBlockSize", 0);
  program->SetUniformi("in_bccMirrored", textureToDataset->Determinant() < 0.0);
  if (this->Target)
  {
    this->Target->StartTracing(program, rays.GetBounds());
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::SetVolumeUniforms(
  vtkShaderProgram* program, vtkGPUVolumeRayCastMapper* mapper)
{
  const vtkBCCVolumeFrame& frame = *this->Input->Frame;
  float box[2][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    box[0][axis] = static_cast<float>(frame.Low[axis]);
    box[1][axis] = static_cast<float>(frame.High[axis] - frame.Low[axis]);
  }
  program->SetUniform3fv("in_bccBox", 2, box);
  if (this->Current.Buffer)
  {
    this->Coefficients.Activate(program);
  }
  else
  {
    program->SetUniformi("in_bccCosetDepth", this->Input->Texels.Size.z / 2);
  }
  this->SetPieceUniforms(program);
  if (program->IsUniformUsed("in_bccToGradient"))
  {
    float toGradient[3][3];
    frame.GetGradientMatrix(toGradient[0]);
    program->SetUniform3fv("in_bccToGradient", 3, toGradient);
  }
  if (program->IsUniformUsed("in_bccLatticePerUnit"))
  {
    program->SetUniform3f("in_bccLatticePerUnit", frame.LatticePerUnit);
  }
  if (program->IsUniformUsed("in_bccMaskMatrix"))
  {
    vtkBCCVolumeMask::SetUniforms(program, mapper->GetMaskInput(), frame,
      this->Input->GetHeldFrame(), vtkImageData::SafeDownCast(mapper->GetTransformedInput(0)));
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::SetColorUniforms(
  vtkShaderProgram* program, const vtkVolumeTexture* texture) const
{
  if (program->IsUniformUsed("in_bccColors"))
  {
    const bool stored = this->Normalizer != 0.0f;
    float colors[2][4];
    for (int component = 0; component < 4; ++component)
    {
      colors[0][component] = stored ? this->Normalizer : texture->Scale[component];
      colors[1][component] = stored ? 0.0f : texture->Bias[component];
    }
    program->SetUniform4fv("in_bccColors", 2, colors);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeShaderStage::SetCropping(vtkShaderProgram* program,
  vtkGPUVolumeRayCastMapper* mapper, vtkMatrix4x4* textureToDataset) const
{
  if (program->IsUniformUsed("in_bccCroppingPlanes"))
  {
    float planes[6];
    for (int n = 0; n < 6; ++n)
    {
      planes[n] = static_cast<float>(
        mapper->GetCroppingRegionPlanes()[n] - textureToDataset->GetElement(n / 2, 3));
    }
    program->SetUniform1fv("in_bccCroppingPlanes", 6, planes);
  }
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeShaderStage::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(abstractMapper);
  vtkVolumeTexture* texture = mapper->AssembledInputs[0].Texture;
  if (!this->FillTexture(texture))
  {
    return false;
  }
  this->SetCells(texture);
  this->SetRayUniforms(program, texture->GetCurrentBlock()->TextureToDataset);
  this->SetVolumeUniforms(program, mapper);
  this->SetColorUniforms(program, texture);
  this->SetCropping(program, mapper, texture->GetCurrentBlock()->TextureToDataset);
  if (program->IsUniformUsed("in_bccDepthOpacity"))
  {
    // A translucent surface is picked, but hides nothing.
    const bool picking = this->Renderer->GetSelector() != nullptr;
    program->SetUniformf("in_bccDepthOpacity", picking ? 3.0f / 255.0f : 1.0f - 1.0f / 255.0f);
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (this->Current.SkipRule != vtkBCCBrickTexture::Nothing &&
    !this->Bricks.Activate(program, mapper, this->Volume->GetProperty(), window,
      this->Current.SkipRule, this->Input->GetBricks(), this->Input->LoadTime.GetMTime(),
      this->Normalizer))
  {
    return false;
  }
  if (this->Saved)
  {
    this->Saved->State->vtkglDepthMask(GL_TRUE);
    this->Saved->State->vtkglDepthFunc(GL_ALWAYS); // The shader makes VTK's own depth test.
  }
  return true;
}
