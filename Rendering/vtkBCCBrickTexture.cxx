// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCBrickTexture.h"

#include "BCCBricks.h"
#include "vtkBCCBrickMarks.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVolumeOpacityTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolumeInputHelper.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeTexture.h"

#include <algorithm>

namespace
{

using Scalars = vtkBCCBrickMarks::Scalars;

// The components that rays look opacities up with, and how their values become scalars. Of
// dependent ones it is the last.
std::vector<Scalars> GetComponents(
  vtkVolumeTexture* texture, vtkVolumeProperty* property, int count, float normalizer)
{
  std::vector<Scalars> components;
  // Colours are looked up as they are stored, if they are.
  const bool stored = normalizer != 0.0f;
  const bool scaled = count <= 2 || property->GetIndependentComponents() || !stored;
  for (int n = property->GetIndependentComponents() ? 0 : count - 1; n < count; ++n)
  {
    Scalars scalars;
    scalars.Component = n;
    scalars.Scale = (stored ? normalizer : 1.0f) * (scaled ? texture->Scale[n] : 1.0f);
    scalars.Bias = scaled ? texture->Bias[n] : 0.0f;
    components.push_back(scalars);
  }
  return components;
}

// Where the table that VTK makes of a component's opacities is not 0.
std::vector<bool> FindSeen(vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property,
  vtkVolumeInputHelper& input, int component)
{
  const int index = property->GetIndependentComponents() ? component : 0;
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity(index);
  const float* scalarRange = input.Texture->ScalarRange[component];
  double range[2] = { scalarRange[0], scalarRange[1] };
  if (mapper->GetScalarOpacityRangeType() != vtkGPUVolumeRayCastMapper::SCALAR)
  {
    opacity->GetRange(range);
  }
  std::vector<float> table(std::max(input.OpacityTables->GetTable(index)->GetTextureWidth(), 2));
  opacity->GetTable(range[0], range[1], static_cast<int>(table.size()), table.data());
  std::vector<bool> seen(table.size());
  std::transform(
    table.begin(), table.end(), seen.begin(), [](float value) { return !(value == 0.0f); });
  return seen;
}

// Where a 2D transfer function is not transparent at every gradient, and somewhat beside.
std::vector<bool> FindSeen(vtkImageData* function)
{
  const int* size = function->GetDimensions();
  std::vector<bool> seen(size[0]);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      if (function->GetScalarComponentAsDouble(x, y, 0, 3) != 0.0)
      {
        for (int near = std::max(x - 2, 0); near <= std::min(x + 2, size[0] - 1); ++near)
        {
          seen[near] = true;
        }
      }
    }
  }
  return seen;
}

} // namespace

vtkBCCBrickTexture::vtkBCCBrickTexture() = default;
vtkBCCBrickTexture::~vtkBCCBrickTexture() = default;

//------------------------------------------------------------------------------
vtkBCCBrickTexture::Rule vtkBCCBrickTexture::FindRule(
  vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, int components, bool refined)
{
  const bool labels =
    mapper->GetMaskInput() && mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType;
  const bool independent = components == 1 || property->GetIndependentComponents();
  const bool planar = property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D;
  if (labels || (!independent && components == 3) ||
    (planar && (components > 1 || !property->GetTransferFunction2D())))
  {
    return Nothing;
  }
  // An extremum's opacity is that of the gradient where its ray ends, as VTK has it.
  const bool atEnd = planar || property->HasGradientOpacity();
  switch (mapper->GetBlendMode())
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return Opacity;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return planar || !independent ? Nothing : Opacity;
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return refined && (independent || components == 2) ? IsoValues : Nothing;
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return independent && !atEnd ? Maximum : Nothing;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return independent && !atEnd ? Minimum : Nothing;
    default:
      return Nothing;
  }
}

//------------------------------------------------------------------------------
bool vtkBCCBrickTexture::Fill(vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property,
  Rule rule, const bravais::BCCBricks& bricks, float normalizer)
{
  vtkVolumeInputHelper& input = mapper->AssembledInputs[0];
  std::vector<Scalars> components =
    GetComponents(input.Texture, property, bricks.GetComponents(), normalizer);
  std::vector<std::uint8_t> bytes;
  if (rule == IsoValues)
  {
    vtkContourValues* contours = property->GetIsoSurfaceValues();
    bytes = vtkBCCBrickMarks::FindDistances(bricks,
      std::vector<double>(
        contours->GetValues(), contours->GetValues() + contours->GetNumberOfContours()));
  }
  else if (rule == Opacity)
  {
    for (Scalars& scalars : components)
    {
      scalars.Seen = property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D
        ? FindSeen(property->GetTransferFunction2D())
        : FindSeen(mapper, property, input, scalars.Component);
    }
    bytes = vtkBCCBrickMarks::FindDistances(bricks, components);
  }
  else
  {
    bytes = vtkBCCBrickMarks::FindBounds(bricks, components, rule == Maximum);
  }
  const glm::ivec3& size = bricks.GetSize();
  const auto count = static_cast<unsigned int>(size.x * size.y * size.z);
  const auto type = vtkOpenGLBufferObject::TextureBuffer;
  this->Size = static_cast<vtkIdType>(bytes.size());
  this->Buffer->SetType(type);
  this->Texture->ResetFormatAndType(); // There may be other channels than before.
  return this->Buffer->Upload(bytes, type) &&
    this->Texture->CreateTextureBuffer(
      count, static_cast<int>(bytes.size() / count), VTK_UNSIGNED_CHAR, this->Buffer);
}

//------------------------------------------------------------------------------
bool vtkBCCBrickTexture::Activate(vtkShaderProgram* program,
  vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property,
  vtkOpenGLRenderWindow* window, Rule rule, const bravais::BCCBricks& bricks, vtkMTimeType time,
  float normalizer)
{
  if (this->Texture->GetContext() != window)
  {
    this->Texture->SetContext(window);
  }
  vtkVolumeTexture* texture = mapper->AssembledInputs[0].Texture;
  std::vector<float> scales(texture->Scale, texture->Scale + 4);
  scales.insert(scales.end(), texture->Bias, texture->Bias + 4);
  scales.push_back(static_cast<float>(mapper->GetScalarOpacityRangeType()));
  const auto wanted = std::make_tuple(rule, time, property->GetMTime(),
    property->GetIsoSurfaceValues()->GetMTime(), normalizer, scales);
  if (!this->Texture->GetHandle() || this->Filled != wanted)
  {
    if (!this->Fill(mapper, property, rule, bricks, normalizer))
    {
      return false;
    }
    this->Filled = wanted;
  }
  this->Texture->Activate();
  program->SetUniformi("in_bccBricks", this->Texture->GetTextureUnit());
  program->SetUniform1iv("in_bccBrickCounts", 3, &bricks.GetSize().x);
  return true;
}

//------------------------------------------------------------------------------
void vtkBCCBrickTexture::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkBCCBrickTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}
