// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeShaderText.h"

#include "bayerJitter_glsl.h"
#include "bcc4Polynomial_glsl.h"
#include "bcc7Polynomial_glsl.h"
#include "bcc8Polynomial_glsl.h"
#include "bccBoxSpline_glsl.h"
#include "bccBricks_glsl.h"
#include "bccComponents_glsl.h"
#include "bccCopies_glsl.h"
#include "bccCropping_glsl.h"
#include "bccCubicRows_glsl.h"
#include "bccCubicSpline_glsl.h"
#include "bccCubicWeights_glsl.h"
#include "bccExit_glsl.h"
#include "bccExtremum_glsl.h"
#include "bccFindRoot_glsl.h"
#include "bccFrame_glsl.h"
#include "bccGrazing_glsl.h"
#include "bccHeadlight_glsl.h"
#include "bccIsoSurfaceDec_glsl.h"
#include "bccIsoSurfaceDepth_glsl.h"
#include "bccIsoSurfaceImpl_glsl.h"
#include "bccIsoSurfaceInit_glsl.h"
#include "bccIsoSurfaceNext_glsl.h"
#include "bccIsoSurfaceTerminate_glsl.h"
#include "bccLookAhead_glsl.h"
#include "bccMask_glsl.h"
#include "bccNearest_glsl.h"
#include "bccPickedPoint_glsl.h"
#include "bccPicking_glsl.h"
#include "bccPieceEnter_glsl.h"
#include "bccPieceImpl_glsl.h"
#include "bccPiece_glsl.h"
#include "bccPixelRay_glsl.h"
#include "bccRayCast_glsl.h"
#include "bccRayInit_glsl.h"
#include "bccRay_glsl.h"
#include "bccSkipImpl_glsl.h"
#include "bccSkip_glsl.h"
#include "bccSmallPicture_glsl.h"
#include "bccVolume_glsl.h"

namespace
{
std::string Define(const std::string& name, const std::string& value)
{
  return "#define " + name + " " + value + "\n";
}

// The functions of a kernel that has a reference tetrahedron.
std::string GetBoxSpline(const char* polynomial, const std::string& kernel, int stencil)
{
  return bccFrame_glsl + std::string(polynomial) + Define("BCC_STENCIL", std::to_string(stencil)) +
    Define("BCC_FETCH", kernel + "Fetch") + Define("BCC_POLYNOMIAL", kernel + "Polynomial") +
    bccBoxSpline_glsl;
}
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetSpline(
  bravais::BCCKernel kernel, int components, const std::string& volume)
{
  const std::string count = std::to_string(components);
  const bool buffer = volume.empty();
  const std::string text = (buffer ? Define("BCC_BUFFER", "1") : Define("BCC_VOLUME", volume)) +
    Define("BCC_COMPONENTS", count) +
    Define("BCC_VALUE", components == 1 ? "float" : "vec" + count) +
    Define("BCC_CHANNELS", std::string("rgba").substr(0, components)) + bccVolume_glsl;
  switch (kernel)
  {
    case bravais::BCCKernel::BCC4:
      return text + GetBoxSpline(bcc4Polynomial_glsl, "BCC4", 4);
    case bravais::BCCKernel::BCC7:
      return text + GetBoxSpline(bcc7Polynomial_glsl, "BCC7", 30);
    case bravais::BCCKernel::BCC8:
      return text + GetBoxSpline(bcc8Polynomial_glsl, "BCC8", 32);
    case bravais::BCCKernel::BCC12:
      return (buffer && components == 1 ? Define("BCC_FOURS", "1") : std::string()) + text +
        bccCubicWeights_glsl + (buffer ? bccCubicRows_glsl : bccCubicSpline_glsl);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetRayCast(const std::vector<std::string>& macros)
{
  std::string text;
  for (const std::string& macro : macros)
  {
    text += Define(macro, "1");
  }
  return text + bccCopies_glsl + bccRayCast_glsl + bccRay_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetSkipping(bool extremum)
{
  return extremum
    ? std::string(bccBricks_glsl) + bccExtremum_glsl + bccSkip_glsl + bccLookAhead_glsl
    : std::string(bccBricks_glsl) + bccSkip_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetSkippingImplementation()
{
  return bccSkipImpl_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPiece()
{
  return bccPiece_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPieceInit()
{
  return bccPieceEnter_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPieceImplementation()
{
  return bccPieceImpl_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetRayInit()
{
  return bccRayInit_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetExit()
{
  return bccExit_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPixelRay()
{
  return bccPixelRay_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetSmallPicture()
{
  return bccSmallPicture_glsl;
}

//------------------------------------------------------------------------------
const char* const vtkBCCVolumeShaderText::JitterStatement = "g_rayJitter = g_dirStep;";

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetBayerJitter()
{
  return bayerJitter_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetCropping()
{
  return bccCropping_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetComponents()
{
  return bccComponents_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetHeadlight()
{
  return bccHeadlight_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetMask(bool lattice, bool labels)
{
  return (labels ? Define("BCC_LABELS", "1") : std::string()) +
    (lattice ? Define("BCC_LATTICE_MASK", "1") + bccNearest_glsl : std::string()) + bccMask_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPicking(bool latticeMask)
{
  return (latticeMask ? std::string() : std::string(bccNearest_glsl)) + bccPicking_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetPickedPoint(bool refined, bool higher)
{
  return Define("BCC_PICKED_PLACE", refined ? "g_bccSurface" : "g_dataPos") +
    Define("BCC_PICKED_SHIFT", higher ? "24u" : "0u") + bccPickedPoint_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetFindRoot()
{
  return bccFindRoot_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetIsoSurfaceDeclarations()
{
  return std::string(bccIsoSurfaceDec_glsl) + bccIsoSurfaceNext_glsl + bccGrazing_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetIsoSurfaceDepth()
{
  return bccIsoSurfaceDepth_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetIsoSurfaceInit()
{
  return bccIsoSurfaceInit_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetIsoSurfaceImplementation()
{
  return bccIsoSurfaceImpl_glsl;
}

//------------------------------------------------------------------------------
std::string vtkBCCVolumeShaderText::GetIsoSurfaceTermination()
{
  return bccIsoSurfaceTerminate_glsl;
}
