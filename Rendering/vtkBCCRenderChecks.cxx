// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCRenderChecks.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiVolume.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// VTK's ray caster holds so many.
constexpr int MaximumLights = 6;

// Samples are counted by floats.
constexpr double MaximumSamples = 1 << 23;

template <class Function>
void ForEachLight(vtkRenderer* renderer, Function function)
{
  vtkCollectionSimpleIterator place;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(place);
  while (vtkLight* light = lights->GetNextLight(place))
  {
    function(light);
  }
}

// VTK would look for other masks beyond their arrays.
bool StartsAtZero(const int extent[6])
{
  return extent[0] == 0 && extent[2] == 0 && extent[4] == 0;
}

bool HasNan(vtkContourValues* values)
{
  return std::any_of(values->GetValues(), values->GetValues() + values->GetNumberOfContours(),
    [](double value) { return std::isnan(value); });
}

bool HasScalars(vtkImageData* image)
{
  return image->GetNumberOfCells() > 0 &&
    (image->GetPointData()->GetScalars() || image->GetCellData()->GetScalars());
}
}

//------------------------------------------------------------------------------
bool vtkBCCRenderChecks::Check(
  vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, std::string& why)
{
  vtkVolumeProperty* property = volume->GetProperty();
  const int mode = mapper->GetBlendMode();
  if (vtkMultiVolume::SafeDownCast(volume) || mapper->GetInputCount() > 1)
  {
    why = "There is more than one input; a BCC volume is rendered by itself.";
  }
  else if (mode < vtkVolumeMapper::COMPOSITE_BLEND || mode > vtkVolumeMapper::SLICE_BLEND)
  {
    why = "BlendMode is " + std::to_string(mode) + "; it has to be 0 (composite) to 6 (slice).";
  }
  else if (mode == vtkVolumeMapper::ISOSURFACE_BLEND && HasNan(property->GetIsoSurfaceValues()))
  {
    why = "One of the property's IsoSurfaceValues is nan; they have to be numbers.";
  }
  else if (mapper->GetUseDepthPass() && mode == vtkVolumeMapper::COMPOSITE_BLEND)
  {
    why = "UseDepthPass is on; its contours are those of a Cartesian grid, not of a BCC volume.";
  }
  else if (mode == vtkVolumeMapper::SLICE_BLEND &&
    !vtkPlane::SafeDownCast(property->GetSliceFunction()))
  {
    why = "The property's SliceFunction is not a vtkPlane, which is what slices are cut along.";
  }
  else if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D &&
    mapper->GetTransfer2DYAxisArray())
  {
    why = std::string("Transfer2DYAxisArray is ") + mapper->GetTransfer2DYAxisArray() +
      "; the second axis of 2D transfer functions can only be the gradient's magnitude.";
  }
  else if (mapper->GetMaskInput() && !HasScalars(mapper->GetMaskInput()))
  {
    why = "The mask has no scalars; it has to be an image of labels.";
  }
  else if (mapper->GetMaskInput() && !StartsAtZero(mapper->GetMaskInput()->GetExtent()))
  {
    why = "The mask's extent does not begin at 0, where VTK takes its first label to be.";
  }
  return why.empty();
}

//------------------------------------------------------------------------------
bool vtkBCCRenderChecks::CheckPatterns(int jitter, int size, std::string& why)
{
  if (jitter < 0 || jitter > 2)
  {
    why = "JitterPattern is " + std::to_string(jitter) +
      "; it has to be 0 (None), 1 (VTK) or 2 (Bayer).";
  }
  else if (size != 2 && size != 4 && size != 8)
  {
    why = "ProgressivePatternSize is " + std::to_string(size) + "; it has to be 2, 4 or 8.";
  }
  return why.empty();
}

//------------------------------------------------------------------------------
bool vtkBCCRenderChecks::CheckSampleDistances(
  vtkRenderer* renderer, vtkGPUVolumeRayCastMapper* mapper, double distance, std::string& why)
{
  const bool asked =
    !mapper->GetAutoAdjustSampleDistances() && !mapper->GetLockSampleDistanceToInputSpacing();
  const char* const name = asked ? "SampleDistance" : "The sample distance by the input's spacing";
  const double pixels = mapper->GetImageSampleDistance();
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const double samples = mapper->GetLength() / distance;
  std::ostringstream text;
  if (std::isnan(pixels))
  {
    text << "ImageSampleDistance is nan; it has to be from 0.1 to 100 pixels.";
  }
  else if (pixels > std::min(size[0], size[1]))
  {
    text << "ImageSampleDistance is " << pixels << "; it has to be up to the viewport's size, "
         << size[0] << " x " << size[1] << " pixels.";
  }
  else if (!(distance > 0.0 && std::isfinite(distance)))
  {
    text << name << " is " << distance << "; it has to be a positive number.";
  }
  else if (samples > MaximumSamples)
  {
    text << name << " is " << distance << ", which makes " << samples
         << " samples along the volume's diagonal; there can be " << MaximumSamples << ".";
  }
  why = text.str();
  return why.empty();
}

//------------------------------------------------------------------------------
bool vtkBCCRenderChecks::CheckShading(
  vtkRenderer* renderer, vtkVolume* volume, int components, std::string& why)
{
  vtkVolumeProperty* property = volume->GetProperty();
  int lights = 0;
  ForEachLight(renderer, [&](vtkLight* light) { lights += light->GetSwitch() ? 1 : 0; });
  if (!property->GetIndependentComponents() && components % 2 == 1)
  {
    why = "IndependentComponents is off and the input's scalars have " +
      std::to_string(components) + " components; dependent ones are 2 or 4.";
  }
  else if (property->GetShade() && lights > MaximumLights)
  {
    why = std::to_string(lights) + " lights are on; volumes are shaded by up to " +
      std::to_string(MaximumLights) + ".";
  }
  return why.empty();
}

//------------------------------------------------------------------------------
int vtkBCCRenderChecks::GetLightComplexity(vtkRenderer* renderer)
{
  int complexity = 0;
  int on = 0;
  ForEachLight(renderer,
    [&](vtkLight* light)
    {
      on += light->GetSwitch() ? 1 : 0;
      const bool plain = on <= 1 && light->LightTypeIsHeadlight() && light->GetIntensity() == 1.0;
      const int least = on == 0 ? 0 : plain ? 1 : 2;
      complexity = std::max(complexity, light->GetPositional() ? 3 : least);
    });
  return complexity;
}
