// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCShaderOptions.h"

#include "vtkBCCCoefficientBuffer.h"
#include "vtkBCCRenderChecks.h"
#include "vtkBCCShaderCheck.h"
#include "vtkBCCVolumeInput.h"
#include "vtkBCCVolumeMapper.h"
#include "vtkBCCVolumeMask.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <tuple>

//------------------------------------------------------------------------------
bool vtkBCCShaderOptions::operator==(const vtkBCCShaderOptions& other) const
{
  const auto tie = [](const vtkBCCShaderOptions& o)
  {
    return std::tie(o.Kernel, o.AnalyticGradients, o.RefineRoots, o.WriteDepth, o.BayerJitter,
      o.LightComplexity, o.Mask, o.LatticeMask, o.UserHash, o.SkipRule, o.HalfFloats, o.Buffer,
      o.PixelRays, o.Progressive, o.Components, o.Piece);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
bool vtkBCCShaderOptions::IsDepthTaken(vtkVolume* volume)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  return keys &&
    (keys->Has(vtkOpenGLRenderPass::RenderPasses()) ||
      keys->Has(vtkOpenGLActor::GLDepthMaskOverride()));
}

//------------------------------------------------------------------------------
vtkBCCShaderOptions vtkBCCShaderOptions::Collect(
  vtkBCCVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, vtkBCCVolumeInput& input)
{
  vtkVolumeProperty* property = volume->GetProperty();
  vtkImageData* mask = mapper->GetMaskInput();
  vtkBCCShaderOptions options;
  options.Kernel = static_cast<bravais::BCCKernel>(mapper->GetKernel());
  options.AnalyticGradients = mapper->GetAnalyticGradients();
  options.RefineRoots = mapper->GetIsoSurfaceRefinement() &&
    mapper->GetBlendMode() == vtkVolumeMapper::ISOSURFACE_BLEND &&
    property->GetIsoSurfaceValues()->GetNumberOfContours() > 0;
  options.WriteDepth = options.RefineRoots && !IsDepthTaken(volume);
  options.LightComplexity =
    property->GetShade() ? vtkBCCRenderChecks::GetLightComplexity(renderer) : 0;
  options.Mask = mask ? mapper->GetMaskType() : -1;
  options.LatticeMask = mask && vtkBCCVolumeMask::IsLattice(mask, input.GetHeldFrame());
  options.UserHash = vtkBCCShaderCheck::GetHash(volume);
  options.HalfFloats = mapper->GetHalfFloatCoefficients();
  options.Buffer = vtkBCCCoefficientBuffer::IsBetter(
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), input.Texels);
  options.PixelRays = !IsDepthTaken(volume);
  options.Components = input.Texels.Components;
  options.Piece = input.Piece->IsPart;
  // Where a ray without surfaces ends tells VTK what is picked.
  if (mapper->GetEmptySpaceSkipping() && (options.RefineRoots || !renderer->GetSelector()))
  {
    options.SkipRule =
      vtkBCCBrickTexture::FindRule(mapper, property, options.Components, options.RefineRoots);
  }
  return options;
}
