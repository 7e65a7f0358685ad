// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TexturedPolyDataMapper.h"

#include "vtkRank1ShaderText.h"
#include "vtkRank1TexelTexture.h"
#include "vtkRank1TextureInput.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkRank1TexturedPolyDataMapper);

//------------------------------------------------------------------------------
class vtkRank1TexturedPolyDataMapper::Internals
{
public:
  vtkRank1TextureInput Input;
  vtkRank1TexelTexture Texture;
  std::string LookUp; // its shader's text
  vtkTimeStamp LookUpTime;
  std::string LastError;
  vtkMTimeType LastErrorTime = 0;
};

//------------------------------------------------------------------------------
vtkRank1TexturedPolyDataMapper::vtkRank1TexturedPolyDataMapper()
  : Impl(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkRank1TexturedPolyDataMapper::~vtkRank1TexturedPolyDataMapper()
{
  // Has the window that was drawn in release all, while the override below is there.
  this->Superclass::ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Interpolation: " << this->GetInterpolationAsString() << "\n";
  os << indent << "LevelFilter: " << this->GetLevelFilterAsString() << "\n";
  os << indent << "HalfPrecision: " << (this->HalfPrecision ? "On" : "Off") << "\n";
  os << indent << "TexelTime: " << this->GetTexelTime() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturedPolyDataMapper::GetInterpolationAsString()
{
  constexpr const char* names[] = { "Nearest", "Bilinear", "Barycentric", "BoxSpline" };
  return this->Interpolation >= 0 && this->Interpolation < 4 ? names[this->Interpolation]
                                                             : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturedPolyDataMapper::GetLevelFilterAsString()
{
  constexpr const char* names[] = { "NearestLevel", "Trilinear" };
  return this->LevelFilter >= 0 && this->LevelFilter < 2 ? names[this->LevelFilter] : "Unknown";
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::SetTextureConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::SetTextureData(vtkDataObject* texture)
{
  this->SetInputDataInternal(1, texture);
}

//------------------------------------------------------------------------------
vtkDataObject* vtkRank1TexturedPolyDataMapper::GetTextureData()
{
  return this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRank1TexturedPolyDataMapper::GetTexelTime() const
{
  return this->Impl->Texture.FillTime.GetMTime();
}

//------------------------------------------------------------------------------
int vtkRank1TexturedPolyDataMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  // Anything is let in, so that what is wrong with it is told by RenderPiece, once.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkRank1TexturedPolyDataMapper::UpdateTexture(std::string& why)
{
  if (this->GetNumberOfInputConnections(1) > 0 && !this->Static)
  {
    this->GetInputAlgorithm(1, 0)->UpdateWholeExtent();
  }
  vtkRank1TextureInput& input = this->Impl->Input;
  return input.SetSource(this->GetTextureData(), why);
}

//------------------------------------------------------------------------------
bool vtkRank1TexturedPolyDataMapper::CheckMesh(std::string& why)
{
  vtkPolyData* mesh = this->GetInput();
  if (!mesh)
  {
    why = "There is no mesh; the first input port takes a vtkPolyData.";
    return false;
  }
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  const int components = coordinates ? coordinates->GetNumberOfComponents() : 0;
  if (mesh->GetNumberOfCells() > 0 && components != 2 && components != 3)
  {
    why = coordinates ? "The mesh's texture coordinates have " + std::to_string(components) +
        " component(s); 2, or 3 of which the last one is not used, were expected."
                      : "The mesh has no texture coordinates; those of a point are its place in "
                        "the picture.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRank1TexturedPolyDataMapper::Prepare(vtkRenderer* renderer, std::string& why)
{
  Internals& impl = *this->Impl;
  if (this->GetNumberOfInputConnections(0) > 0 && !this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  if (this->Interpolation < 0 || this->Interpolation > 3)
  {
    why = "Interpolation is " + std::to_string(this->Interpolation) +
      "; 0 (Nearest), 1 (Bilinear), 2 (Barycentric) or 3 (BoxSpline) was expected.";
    return false;
  }
  if (this->LevelFilter != 0 && this->LevelFilter != 1)
  {
    why = "LevelFilter is " + std::to_string(this->LevelFilter) +
      "; 0 (NearestLevel) or 1 (Trilinear) was expected.";
    return false;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  window->MakeCurrent();
  if (!this->CheckMesh(why) || !this->UpdateTexture(why) ||
    !impl.Input.Fold(vtkTextureObject::GetMaximumTextureSize(window), why))
  {
    return false;
  }
  const std::string lookUp =
    vtkRank1ShaderText::GetLookUp(impl.Input, this->Interpolation, this->LevelFilter);
  if (impl.LookUp != lookUp)
  {
    impl.LookUp = lookUp;
    impl.LookUpTime.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::ReportOnce(const std::string& why)
{
  vtkDataObject* mesh = this->GetNumberOfInputConnections(0) > 0 ? this->GetInput() : nullptr;
  const vtkMTimeType time = std::max({ this->GetMTime(), mesh ? mesh->GetMTime() : 0,
    vtkRank1TextureInput::GetTime(this->GetTextureData()) });
  if (this->Impl->LastError != why || this->Impl->LastErrorTime != time)
  {
    this->Impl->LastError = why;
    this->Impl->LastErrorTime = time;
    vtkErrorMacro(<< why);
  }
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  std::string why;
  if (this->GetNumberOfInputConnections(0) < 1 && !this->CheckMesh(why))
  {
    this->ReportOnce(why); // The superclass would report it for every frame.
    return;
  }
  this->Superclass::Render(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  std::string why;
  if (!this->Prepare(renderer, why))
  {
    this->ReportOnce(why);
    return;
  }
  this->Superclass::RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass has released what is in another window by now.
  Internals& impl = *this->Impl;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!impl.Texture.Fill(window, impl.Input, this->HalfPrecision))
  {
    this->ReportOnce("OpenGL failed to make a texture of " +
      std::to_string(1 << impl.Input.Log2Columns) + " x " + std::to_string(impl.Input.Rows) +
      " texels.");
  }
  else
  {
    impl.LastError.clear();
    impl.Texture.Texture->Activate();
  }
  this->Superclass::RenderPieceStart(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Impl->Texture.Texture)
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
  }
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  if (this->Impl->Texture.Texture)
  {
    this->Impl->Texture.Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // In the end the superclass calls this again with the window's context.
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Texture.Release(window);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::ShallowCopy(vtkAbstractMapper* other)
{
  if (auto* mapper = vtkRank1TexturedPolyDataMapper::SafeDownCast(other))
  {
    this->SetInputConnection(
      1, mapper->GetNumberOfInputConnections(1) > 0 ? mapper->GetInputConnection(1, 0) : nullptr);
    this->SetInterpolation(mapper->GetInterpolation());
    this->SetLevelFilter(mapper->GetLevelFilter());
    this->SetHalfPrecision(mapper->GetHalfPrecision());
  }
  this->Superclass::ShallowCopy(other);
}

//------------------------------------------------------------------------------
bool vtkRank1TexturedPolyDataMapper::HasTranslucentPolygonalGeometry()
{
  std::string why; // told when it is drawn
  return this->Superclass::HasTranslucentPolygonalGeometry() ||
    (this->UpdateTexture(why) && this->Impl->Input.Translucent);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->CurrentInput)
  {
    // An attribute of its own: that of VTK's textures may be a colour's place in a lookup table.
    this->VBOs->CacheDataArray(
      "rank1TCoord", this->CurrentInput->GetPointData()->GetTCoords(), renderer, VTK_FLOAT);
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
bool vtkRank1TexturedPolyDataMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass has to look in any case, as it remembers what it saw.
  return this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor) ||
    helper.ShaderSourceTime < this->Impl->LookUpTime;
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::ReplaceShaderTCoord(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->DrawingVertices)
  {
    std::string vertex = shaders[vtkShader::Vertex]->GetSource();
    std::string geometry = shaders[vtkShader::Geometry]->GetSource();
    std::string fragment = shaders[vtkShader::Fragment]->GetSource();
    vtkRank1ShaderText::ReplaceVertex(vertex);
    vtkRank1ShaderText::ReplaceGeometry(geometry);
    vtkRank1ShaderText::ReplaceFragment(fragment, this->Impl->LookUp);
    shaders[vtkShader::Vertex]->SetSource(vertex);
    shaders[vtkShader::Geometry]->SetSource(geometry);
    shaders[vtkShader::Fragment]->SetSource(fragment);
  }
  this->Superclass::ReplaceShaderTCoord(shaders, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkRank1TexturedPolyDataMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  vtkShaderProgram* program = helper.Program;
  if (!program->IsUniformUsed("in_rank1Texels"))
  {
    return; // edges and vertices are drawn without
  }
  program->SetUniformi("in_rank1Texels", this->Impl->Texture.Texture->GetTextureUnit());
  program->SetUniformi(
    "in_rank1ShowOnBackface", actor->GetProperty()->GetShowTexturesOnBackface() ? 1 : 0);
  float matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  vtkInformation* keys = actor->GetPropertyKeys();
  if (keys && keys->Has(vtkProp::GeneralTextureTransform()))
  {
    const double* rows = keys->Get(vtkProp::GeneralTextureTransform());
    for (int i = 0; i < 16; ++i)
    {
      matrix[i] = static_cast<float>(rows[4 * (i % 4) + i / 4]);
    }
  }
  program->SetUniformMatrix4x4("in_rank1TCoordMatrix", matrix);
}
