// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1ShaderText.h"

#include "vtkRank1TextureInput.h"

#include "rank1BoxSpline_glsl.h"
#include "rank1Footprint_glsl.h"
#include "rank1FragmentDec_glsl.h"
#include "rank1FragmentImpl_glsl.h"
#include "rank1GeometryDec_glsl.h"
#include "rank1GeometryImpl_glsl.h"
#include "rank1Index_glsl.h"
#include "rank1Interpolation_glsl.h"
#include "rank1Level_glsl.h"
#include "rank1LookUp_glsl.h"
#include "rank1Texture_glsl.h"
#include "rank1VertexDec_glsl.h"
#include "rank1VertexImpl_glsl.h"

#include "vtkShaderProgram.h"

namespace
{
std::string Define(const std::string& name, const std::string& value)
{
  return "#define " + name + " " + value + "\n";
}

std::string Define(const std::string& name, std::size_t value)
{
  return Define(name, std::to_string(value));
}

void PutBefore(std::string& source, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(source, tag, text + tag);
}
}

//------------------------------------------------------------------------------
std::string vtkRank1ShaderText::GetLookUp(
  const vtkRank1TextureInput& input, int interpolation, int levelFilter)
{
  constexpr const char* find[] = { "FindRank1Nearest", "FindRank1Bilinear", "FindRank1Barycentric",
    "FindRank1BoxSpline" };
  constexpr std::size_t stencil[] = { 1, 4, 3, 12 };
  std::string text = Define("RANK1_LEVELS", input.Texels.size()) +
    Define("RANK1_SET_COLUMNS", static_cast<std::size_t>(input.Levels.Columns)) +
    Define("RANK1_COMPONENTS", static_cast<std::size_t>(input.Components)) +
    Define("RANK1_FIND", find[interpolation]) + Define("RANK1_STENCIL", stencil[interpolation]);
  text += input.PowerOfTwo ? Define("RANK1_POWER_OF_TWO", 1) : "";
  text += input.Tiled ? Define("RANK1_TILED", 1) : "";
  text += input.Levels.IsRSet ? Define("RANK1_R_SET", 1) : "";
  text += levelFilter == 1 ? Define("RANK1_TRILINEAR", 1) : "";
  return text + input.GetConstants() + rank1Texture_glsl + rank1Index_glsl +
    rank1Interpolation_glsl + rank1BoxSpline_glsl + rank1Level_glsl + rank1LookUp_glsl;
}

//------------------------------------------------------------------------------
void vtkRank1ShaderText::ReplaceVertex(std::string& source)
{
  PutBefore(source, "//VTK::TCoord::Dec", rank1VertexDec_glsl);
  PutBefore(source, "//VTK::TCoord::Impl", rank1VertexImpl_glsl);
}

//------------------------------------------------------------------------------
void vtkRank1ShaderText::ReplaceGeometry(std::string& source)
{
  PutBefore(source, "//VTK::TCoord::Dec", rank1GeometryDec_glsl);
  PutBefore(source, "//VTK::TCoord::Impl", rank1GeometryImpl_glsl);
}

//------------------------------------------------------------------------------
void vtkRank1ShaderText::ReplaceFragment(std::string& source, const std::string& lookUp)
{
  PutBefore(source, "//VTK::TCoord::Dec", lookUp + rank1FragmentDec_glsl);
  PutBefore(source, "//VTK::UniformFlow::Impl", rank1Footprint_glsl);
  PutBefore(source, "//VTK::TCoord::Impl", rank1FragmentImpl_glsl);
}
