// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeShaderStage.h"

#include "vtkBCCProgressiveFrame.h"
#include "vtkBCCVolumeInput.h"
#include "vtkBCCVolumeMask.h"
#include "vtkBCCVolumeRays.h"
#include "vtkBCCVolumeShaderText.h"

#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeTexture.h"
#include "vtk_glew.h"

vtkStandardNewMacro(vtkBCCVolumeShaderStage);

namespace
{
const char* const RayTag = "//Bravais::Ray::Dec";

// Has VTK take the place of BCCFindPixelRay() for where the fragment is, and what it takes from
// vertices.
void ReplaceRay(std::string& fragment)
{
  using Program = vtkShaderProgram;
  Program::Substitute(fragment, "in vec3 ip_textureCoords;", "vec3 ip_textureCoords;");
  Program::Substitute(
    fragment, "in vec3 ip_vertexPos;", "vec3 ip_vertexPos;\nvec4 g_bccFragCoord;");
  Program::Substitute(
    fragment, "in mat4 ip_inverseTextureDataAdjusted;", "mat4 ip_inverseTextureDataAdjusted;");
  Program::Substitute(fragment, "gl_FragCoord", "g_bccFragCoord");
  Program::Substitute(fragment, RayTag, vtkBCCVolumeShaderText::GetPixelRay());
}
}

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
bool vtkBCCVolumeShaderStage::PreReplaceShaderValues(std::string&, std::string& geometry,
  std::string& fragment, vtkAbstractMapper* abstractMapper, vtkProp*)
{
  using Text = vtkBCCVolumeShaderText;
  auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(abstractMapper);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  const auto after = [&](const std::string& tag, const std::string& text)
  { vtkShaderProgram::Substitute(fragment, tag, tag + "\n" + text); };
  const auto before = [&](const std::string& tag, const std::string& text)
  { vtkShaderProgram::Substitute(fragment, tag, text + "\n" + tag); };
  const auto instead = [&](const std::string& tag, const std::string& text)
  { vtkShaderProgram::Substitute(fragment, tag, text); };

  std::vector<std::string> macros;
  const auto add = [&](bool condition, const char* macro)
  {
    if (condition)
    {
      macros.emplace_back(macro);
    }
  };
  const bool binaryMask =
    mapper->GetMaskInput() && mapper->GetMaskType() != vtkGPUVolumeRayCastMapper::LabelMapMaskType;
  const bool manyIndependent = this->Current.Components > 1 && property->GetIndependentComponents();
  // With clipped voxels of a given intensity the gradient is not the spline's.
  const bool analytic = this->Current.AnalyticGradients &&
    !(mapper->GetClippingPlanes() && property->GetUseClippedVoxelIntensity());
  add(analytic, "BCC_ANALYTIC_GRADIENTS");
  add((property->HasGradientOpacity() || property->HasLabelGradientOpacity()) &&
      !property->GetDisableGradientOpacity(),
    "BCC_GRADIENT_OPACITY");
  add(mapper->GetCropping(), "BCC_CROPPING");
  add(binaryMask, "BCC_BINARY_MASK");
  add(manyIndependent, "BCC_INDEPENDENT");
  add(mapper->GetRenderToImage(), "BCC_RENDER_TO_IMAGE");
  // Where VTK looks up a sample's value before its gradient, which has the same coefficients. bcc12
  // has its own fetches for each.
  const int blend = mapper->GetBlendMode();
  add(analytic && this->Current.Kernel != bravais::BCCKernel::BCC12 && !this->Current.RefineRoots &&
      property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D &&
      (blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::SLICE_BLEND ||
        blend == vtkVolumeMapper::ISOSURFACE_BLEND),
    "BCC_SHARED_GRADIENTS");
  add(this->Current.Piece, "BCC_PIECE");
  const bool slice = blend == vtkVolumeMapper::SLICE_BLEND;
  add(slice, "BCC_SLICE");
  add(blend == vtkVolumeMapper::ISOSURFACE_BLEND, "BCC_ISOSURFACE");
  const vtkBCCBrickTexture::Rule rule = this->Current.SkipRule;
  const bool skip = rule != vtkBCCBrickTexture::Nothing;
  const bool extremum = rule == vtkBCCBrickTexture::Maximum || rule == vtkBCCBrickTexture::Minimum;
  add(skip && !extremum, "BCC_SKIP_DISTANCE");
  add(extremum, "BCC_SKIP_EXTREMUM");
  add(rule == vtkBCCBrickTexture::Minimum, "BCC_SKIP_MINIMUM");

  if (this->Current.PixelRays)
  {
    before("//VTK::Picking::Dec", RayTag);
    before("//VTK::Base::Init", "  BCCFindPixelRay();");
  }
  if (this->Current.Progressive)
  {
    geometry = Text::GetSmallPicture();
  }

  const std::string declarations = Text::GetSpline(this->Current.Kernel, this->Current.Components,
                                     this->Current.Buffer ? "" : "in_volume[0]") +
    Text::GetRayCast(macros) + (this->Current.Piece ? Text::GetPiece() : std::string()) +
    (skip ? Text::GetSkipping(extremum) : std::string());
  if (mapper->GetMaskInput())
  {
    after("//VTK::BinaryMask::Dec", Text::GetMask(this->Current.LatticeMask));
  }
  if (this->Renderer->GetSelector())
  {
    after("//VTK::Picking::Dec", Text::GetPicking(this->Current.LatticeMask));
  }
  if (this->Current.RefineRoots)
  {
    after("//VTK::RenderToImage::Dec", Text::GetIsoSurfaceDeclarations() + Text::GetFindRoot());
    instead("//VTK::Shading::Impl", Text::GetIsoSurfaceImplementation());
    instead("//VTK::Terminate::Impl", Text::GetIsoSurfaceTermination());
    after("//VTK::Shading::Init", Text::GetIsoSurfaceInit());
    after("//VTK::Terminate::Init", "  g_bccDepth = l_depthValue.x;\n  g_bccDepthTaken = false;");
  }
  else
  {
    // All samples count where nothing cuts the volume.
    const bool ahead = extremum && !this->Current.Piece && !mapper->GetMaskInput() &&
      !mapper->GetCropping() &&
      !(mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0);
    after("//VTK::Shading::Init",
      std::string("  BCCStartRay();\n") + (skip ? "  BCCStartSkipping();\n" : "") +
        (this->Current.Piece ? Text::GetPieceInit() : std::string()) +
        (ahead ? "  BCCLookAhead();\n" : ""));
    // The later one comes first.
    if (this->Current.Piece)
    {
      after("//VTK::Base::Impl", Text::GetPieceImplementation());
    }
    if (skip)
    {
      after("//VTK::Base::Impl", Text::GetSkippingImplementation());
    }
  }
  if (this->Current.WriteDepth)
  {
    after("//VTK::Base::Exit", "  gl_FragDepth = g_bccDepth;");
  }
  if (this->Current.Progressive)
  {
    const std::string depth = this->Current.WriteDepth ? "g_bccDepth" : "g_bccFragCoord.z";
    after("//VTK::Base::Exit", "  gl_FragData[1] = vec4(" + depth + ");");
  }
  const std::string gradientTag = "//VTK::ComputeGradient::Dec";
  if (analytic)
  {
    instead(gradientTag, declarations);
  }
  else
  {
    before(gradientTag, declarations);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeShaderStage::PostReplaceShaderValues(
  std::string& vertex, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*)
{
  const bool values = vtkShaderProgram::Substitute(
    fragment, "texture3D(in_volume[0], g_dataPos)", "BCCLookUp(g_dataPos)");
  // The statement stays, for replacements of the user's.
  const std::string step = "g_dataPos += g_dirStep;";
  vtkShaderProgram::Substitute(fragment, step, step + " BCCAdvance(1.0);");
  // The differences that VTK takes where gradients are not analytic.
  vtkShaderProgram::Substitute(fragment, "texture3D(volume, vec3(", "BCCLookUp(vec3(");
  vtkShaderProgram::Substitute(
    fragment, "uvec3(in_textureExtentsMax - in_textureExtentsMin)", "BCCPickedCounts()");
  // VTK counts from 1, as its selector once did.
  vtkShaderProgram::Substitute(fragment, "voxelCoords.x + uint(1)", "voxelCoords.x");
  vtkShaderProgram::Substitute(fragment, "uvec3(volumeDim * g_dataPos)",
    this->Current.RefineRoots ? "BCCPicked(g_bccSurface)" : "BCCPicked(g_dataPos)");
  if (fragment.find("vec3 BCCToEye(") != std::string::npos)
  {
    for (const std::string gradient : { "normal", "gradient.xyz" })
    {
      vtkShaderProgram::Substitute(fragment,
        "(in_textureToEye[0] * vec4(" + gradient + ", 0.0)).xyz", "BCCToEye(" + gradient + ")");
    }
  }
  vtkShaderProgram::Substitute(fragment, "texture3D(in_mask, g_dataPos)", "BCCMask(g_dataPos)");
  if (this->Current.BayerJitter)
  {
    vtkShaderProgram::Substitute(
      fragment, vtkBCCVolumeShaderText::JitterStatement, vtkBCCVolumeShaderText::GetBayerJitter());
  }
  if (this->Current.PixelRays)
  {
    ReplaceRay(fragment);
  }
  this->Check.Check(this->Volume, vertex, fragment);
  return values || this->Current.RefineRoots;
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
        vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow()), texels,
        this->Current.HalfFloats);
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
bool vtkBCCVolumeShaderStage::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  auto* mapper = vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(abstractMapper);
  vtkVolumeTexture* texture = mapper->AssembledInputs[0].Texture;
  if (!this->FillTexture(texture))
  {
    return false;
  }
  // VTK divides by one cell less than there are.
  const vtkBCCVolumeFrame& frame = *this->Input->Frame;
  auto* block = texture->GetCurrentBlock();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = frame.Extent[2 * axis + 1] - frame.Extent[2 * axis] + 1;
    block->CellStep[axis] = 1.0f / static_cast<float>(axis == 2 ? points - 1 : points);
    texture->CellSpacing[axis] = static_cast<float>(frame.Spacing[axis]);
  }
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkBCCVolumeRays rays;
  rays.Compute(this->Renderer, viewport, block->TextureToDataset, this->Volume->GetMatrix());
  rays.SetUniforms(program);
  program->SetUniformi("in_bccBlockSize", 0);
  if (this->Target)
  {
    this->Target->StartTracing(program, rays.GetBounds());
  }
  program->SetUniform3f("in_bccLow", frame.Low);
  program->SetUniform3f("in_bccHigh", frame.High);
  program->SetUniformi("in_bccCosetDepth", this->Input->Texels.Size.z / 2);
  if (this->Current.Buffer)
  {
    this->Coefficients.Activate(program, this->Input->Texels);
  }
  this->SetPieceUniforms(program);
  if (program->IsUniformUsed("in_bccToGradient"))
  {
    float toGradient[9];
    frame.GetGradientMatrix(toGradient);
    program->SetUniformMatrix3x3("in_bccToGradient", toGradient);
  }
  if (program->IsUniformUsed("in_bccNormalizer"))
  {
    program->SetUniformf("in_bccNormalizer", this->Normalizer);
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
