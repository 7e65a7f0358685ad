// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCShaderEdits.h"

#include "vtkBCCShaderOptions.h"
#include "vtkBCCVolumeShaderText.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkPlaneCollection.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <vector>

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

bool IsAnalytic(const vtkBCCShaderOptions& options, vtkGPUVolumeRayCastMapper* mapper,
  vtkVolumeProperty* property)
{
  // With clipped voxels of a given intensity the gradient is not the spline's.
  return options.AnalyticGradients &&
    !(mapper->GetClippingPlanes() && property->GetUseClippedVoxelIntensity());
}

bool IsExtremum(vtkBCCBrickTexture::Rule rule)
{
  return rule == vtkBCCBrickTexture::Maximum || rule == vtkBCCBrickTexture::Minimum;
}

// What is defined for the files of GLSL/.
std::vector<std::string> GetMacros(const vtkBCCShaderOptions& options,
  vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property)
{
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
  const bool manyIndependent = options.Components > 1 && property->GetIndependentComponents();
  const bool analytic = IsAnalytic(options, mapper, property);
  add(analytic, "BCC_ANALYTIC_GRADIENTS");
  add((property->HasGradientOpacity() || property->HasLabelGradientOpacity()) &&
      !property->GetDisableGradientOpacity(),
    "BCC_GRADIENT_OPACITY");
  add(mapper->GetCropping(), "BCC_CROPPING");
  add(binaryMask, "BCC_BINARY_MASK");
  add(options.Components == 1 && property->GetTransferFunction2D() &&
      property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D,
    "BCC_TRANSFER_2D");
  add(manyIndependent, "BCC_INDEPENDENT");
  add(mapper->GetRenderToImage(), "BCC_RENDER_TO_IMAGE");
  // Where VTK looks up a sample's value before its gradient, which has the same coefficients. bcc12
  // has its own fetches for each, or the compiler finds those that are the same.
  const int blend = mapper->GetBlendMode();
  add(analytic && options.Kernel != bravais::BCCKernel::BCC12 && !options.RefineRoots &&
      property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D &&
      (blend == vtkVolumeMapper::COMPOSITE_BLEND || blend == vtkVolumeMapper::SLICE_BLEND ||
        blend == vtkVolumeMapper::ISOSURFACE_BLEND),
    "BCC_SHARED_GRADIENTS");
  add(options.Piece, "BCC_PIECE");
  add(blend == vtkVolumeMapper::SLICE_BLEND, "BCC_SLICE");
  add(blend == vtkVolumeMapper::SLICE_BLEND && options.PixelRays, "BCC_CUT_SLICE");
  add(blend == vtkVolumeMapper::ISOSURFACE_BLEND, "BCC_ISOSURFACE");
  const vtkBCCBrickTexture::Rule rule = options.SkipRule;
  const bool extremum = IsExtremum(rule);
  add(rule != vtkBCCBrickTexture::Nothing && !extremum, "BCC_SKIP_DISTANCE");
  add(extremum, "BCC_SKIP_EXTREMUM");
  add(rule == vtkBCCBrickTexture::Minimum, "BCC_SKIP_MINIMUM");
  // All samples count where nothing cuts the volume.
  add(extremum && !options.Piece && !mapper->GetMaskInput() && !mapper->GetCropping() &&
      !(mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0),
    "BCC_LOOK_AHEAD");
  add(options.WriteDepth, "BCC_WRITE_DEPTH");
  add(options.Progressive, "BCC_PROGRESSIVE");
  return macros;
}

// VTK 9.1 does not go back to a simpler kind of lighting once there were lights that need another.
void EditLights(const vtkBCCShaderOptions& options, std::string& fragment)
{
  using Program = vtkShaderProgram;
  const std::string end = "finalColor.a = color.a;";
  if (options.LightComplexity == 0 && fragment.find("in_diffuse[component]") != std::string::npos)
  {
    Program::Substitute(fragment, end, "finalColor.rgb = vec3(0.0);\n" + end);
  }
  else if (options.LightComplexity == 1 && fragment.find("lightNum++") != std::string::npos)
  {
    const std::string lighting = "vec4 computeLighting(";
    Program::Substitute(fragment, lighting, vtkBCCVolumeShaderText::GetHeadlight() + lighting);
    Program::Substitute(
      fragment, end, "finalColor.rgb = BCCHeadlight(color.rgb, component, gradient.xyz);\n" + end);
  }
  else if (options.LightComplexity == 2)
  {
    // As VTK has highlights of lights without a position: the last one's, seen from its direction.
    if (Program::Substitute(fragment, "normalize(vertLightDirection + viewDirection)",
          "normalize(vertLightDirection + normalize((in_modelViewMatrix * in_volumeMatrix[0] * "
          "in_textureDatasetMatrix[0] * vec4(-g_dataPos, 1.0)).xyz))"))
    {
      Program::Substitute(fragment, "specular += (sf *", "specular = (sf *");
    }
  }
}

void PutAfter(std::string& fragment, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(fragment, tag, tag + "\n" + text);
}

void PutBefore(std::string& fragment, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(fragment, tag, text + "\n" + tag);
}

// What is done for each ray and sample.
void EditRays(const vtkBCCShaderOptions& options, std::string& fragment)
{
  using Text = vtkBCCVolumeShaderText;
  PutAfter(fragment, "//VTK::Base::Exit", Text::GetExit());
  if (options.RefineRoots)
  {
    PutAfter(fragment, "//VTK::RenderToImage::Dec",
      Text::GetIsoSurfaceDeclarations() + Text::GetFindRoot());
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Shading::Impl", Text::GetIsoSurfaceImplementation());
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Terminate::Impl", Text::GetIsoSurfaceTermination());
    PutAfter(fragment, "//VTK::Shading::Init", Text::GetIsoSurfaceInit());
    PutAfter(fragment, "//VTK::Terminate::Init", Text::GetIsoSurfaceDepth());
    return;
  }
  PutAfter(fragment, "//VTK::Shading::Init",
    Text::GetRayInit() + (options.Piece ? Text::GetPieceInit() : std::string()));
  // The later one comes first.
  if (options.Piece)
  {
    PutAfter(fragment, "//VTK::Base::Impl", Text::GetPieceImplementation());
  }
  if (options.SkipRule != vtkBCCBrickTexture::Nothing)
  {
    PutAfter(fragment, "//VTK::Base::Impl", Text::GetSkippingImplementation());
  }
}
}

//------------------------------------------------------------------------------
void vtkBCCShaderEdits::EditBefore(const vtkBCCShaderOptions& options,
  vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, std::string& geometry,
  std::string& fragment)
{
  using Text = vtkBCCVolumeShaderText;
  if (options.PixelRays)
  {
    PutBefore(fragment, "//VTK::Picking::Dec", RayTag);
    PutBefore(fragment, "//VTK::Base::Init", "  BCCFindPixelRay();");
  }
  if (options.Progressive)
  {
    geometry = Text::GetSmallPicture();
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    const int count = std::max(planes->GetNumberOfItems(), 8);
    PutBefore(fragment, "//VTK::Clipping::Dec",
      "#define BCC_CLIPPING_VALUES " + std::to_string(1 + 6 * count));
  }
  if (mapper->GetCropping())
  {
    PutAfter(fragment, "//VTK::Cropping::Dec", Text::GetCropping());
  }
  if (mapper->GetBlendMode() == vtkVolumeMapper::SLICE_BLEND && options.Components > 1 &&
    property->GetIndependentComponents())
  {
    PutAfter(fragment, "//VTK::ComputeColor::Dec", Text::GetComponents());
  }
  if (mapper->GetMaskInput())
  {
    const bool labels = mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType;
    PutAfter(fragment, "//VTK::CompositeMask::Dec", Text::GetMask(options.LatticeMask, labels));
  }
  EditRays(options, fragment);
  std::string declarations =
    Text::GetSpline(options.Kernel, options.Components, options.Buffer ? "" : "in_volume[0]") +
    Text::GetRayCast(GetMacros(options, mapper, property));
  if (options.Piece)
  {
    declarations += Text::GetPiece();
  }
  if (options.SkipRule != vtkBCCBrickTexture::Nothing)
  {
    declarations += Text::GetSkipping(IsExtremum(options.SkipRule));
  }
  const std::string tag = "//VTK::ComputeGradient::Dec";
  const bool alone = IsAnalytic(options, mapper, property); // without VTK's differences
  vtkShaderProgram::Substitute(fragment, tag, alone ? declarations : declarations + "\n" + tag);
}

//------------------------------------------------------------------------------
void vtkBCCShaderEdits::EditPicking(
  const vtkBCCShaderOptions& options, int pass, std::string& fragment)
{
  using Text = vtkBCCVolumeShaderText;
  PutAfter(fragment, "//VTK::Picking::Dec", Text::GetPicking(options.LatticeMask));
  const bool higher = pass == vtkHardwareSelector::POINT_ID_HIGH24;
  if (higher || pass == vtkHardwareSelector::POINT_ID_LOW24)
  {
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Picking::Exit", Text::GetPickedPoint(options.RefineRoots, higher));
  }
}

//------------------------------------------------------------------------------
bool vtkBCCShaderEdits::EditAfter(
  const vtkBCCShaderOptions& options, bool picking, std::string& fragment)
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
  // Of independent components VTK keeps the largest for the least, and adds opacity to blue.
  vtkShaderProgram::Substitute(fragment, "l_minValue[i] < scalar[i]", "l_minValue[i] > scalar[i]");
  vtkShaderProgram::Substitute(
    fragment, "g_srcColor[2] += tmp[3] * tmp[3]", "g_srcColor[3] += tmp[3]");
  // VTK turns the normal of a slice as if it were a point, and takes short ones for none.
  vtkShaderProgram::Substitute(fragment,
    "in_inverseVolumeMatrix[0] * vec4(in_slicePlaneNormal, 0.0)",
    "vec4(normalize(transpose(mat3(in_volumeMatrix[0])) * in_slicePlaneNormal), 0.0)");
  // VTK has room for eight planes, and reads on behind them.
  vtkShaderProgram::Substitute(
    fragment, "in_clippingPlanes[49]", "in_clippingPlanes[BCC_CLIPPING_VALUES]");
  // VTK counts from 1, as its selector once did.
  vtkShaderProgram::Substitute(fragment, "voxelCoords.x + uint(1)", "voxelCoords.x");
  vtkShaderProgram::Substitute(fragment, "uvec3(volumeDim * g_dataPos)",
    options.RefineRoots ? "BCCPicked(g_bccSurface)" : "BCCPicked(g_dataPos)");
  if (picking)
  {
    // A selection of points keeps the depths of a picture, among which are those of this surface.
    const std::string depth = "texture2D(in_depthSampler, fragTexCoord)";
    vtkShaderProgram::Substitute(fragment, depth, "(" + depth + " + 1e-5)");
  }
  for (const std::string gradient : { "normal", "gradient.xyz" })
  {
    vtkShaderProgram::Substitute(fragment, "(in_textureToEye[0] * vec4(" + gradient + ", 0.0)).xyz",
      "BCCToEye(" + gradient + ")");
  }
  EditLights(options, fragment);
  vtkShaderProgram::Substitute(fragment, "texture3D(in_mask, g_dataPos)", "BCCMask(g_dataPos)");
  vtkShaderProgram::Substitute(
    fragment, "maskValue.r * in_mask_scale + in_mask_bias", "BCCLabel(maskValue.r)");
  vtkShaderProgram::Substitute(
    fragment, "computeRegion(croppingPlanesTexture, g_dataPos)", "BCCRegion(g_dataPos)");
  if (options.BayerJitter)
  {
    vtkShaderProgram::Substitute(
      fragment, vtkBCCVolumeShaderText::JitterStatement, vtkBCCVolumeShaderText::GetBayerJitter());
  }
  if (options.PixelRays)
  {
    ReplaceRay(fragment);
  }
  return values || options.RefineRoots;
}
