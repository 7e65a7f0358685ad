// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{

const std::array<double, 3> Skin = { 0.93, 0.71, 0.58 };
const std::array<double, 3> Muscle = { 0.78, 0.38, 0.30 };
const std::array<double, 3> Bone = { 0.96, 0.91, 0.80 };

void AddColor(vtkColorTransferFunction* function, double value, const std::array<double, 3>& color)
{
  function->AddRGBPoint(value, color[0], color[1], color[2]);
}

/// Colour and opacity at each value.
void FillIsoSurfaces(const std::vector<Surface>& surfaces, double low,
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities, vtkContourValues* contours)
{
  int number = 0;
  AddColor(colors, low, surfaces.front().Color); // VTK wants two points
  for (const Surface& surface : surfaces)
  {
    AddColor(colors, surface.Value, surface.Color);
    opacities->AddPoint(surface.Value, surface.Opacity);
    contours->SetValue(number++, surface.Value);
  }
}

/// Opacity rises about each value over a tenth of the distance to the next.
void FillLayers(const std::vector<Surface>& surfaces, double low, double high,
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities)
{
  opacities->AddPoint(low, 0.0);
  double below = 0.0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const Surface& surface = surfaces[s];
    const double next = s + 1 < surfaces.size() ? surfaces[s + 1].Value : high;
    const double former = s > 0 ? surfaces[s - 1].Value : low;
    const double ramp = 0.15 * std::min(next - surface.Value, surface.Value - former);
    opacities->AddPoint(surface.Value - ramp, below);
    opacities->AddPoint(surface.Value + ramp, surface.Opacity);
    AddColor(colors, surface.Value - ramp, surface.Color);
    AddColor(colors, surface.Value + ramp, surface.Color);
    below = surface.Opacity;
    if (s + 1 < surfaces.size()) // the inside of a layer, thinner than its skin
    {
      below = 0.1 * surface.Opacity;
      opacities->AddPoint(surface.Value + 3.0 * ramp, below);
      AddColor(colors, 0.5 * (surface.Value + next), Muscle);
    }
  }
  opacities->AddPoint(high, below);
}

} // namespace

std::vector<Surface> MakeSurfaces(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  std::vector<Surface> surfaces;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const double t = values.size() > 1 ? static_cast<double>(v) / (values.size() - 1) : 1.0;
    Surface surface{ values[v], {}, v + 1 < values.size() ? 0.3 : 1.0 };
    for (int c = 0; c < 3; ++c)
    {
      surface.Color[c] = (1.0 - t) * Skin[c] + t * Bone[c];
    }
    surfaces.push_back(surface);
  }
  return surfaces;
}

vtkSmartPointer<vtkVolumeProperty> MakeAppearance(
  Mode mode, const std::vector<Surface>& surfaces, double low, double high, double unitDistance)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  vtkSmartPointer<vtkVolumeProperty> property = vtkSmartPointer<vtkVolumeProperty>::New();
  switch (mode)
  {
    case Mode::IsoSurface:
      FillIsoSurfaces(surfaces, low, colors, opacities, property->GetIsoSurfaceValues());
      break;
    case Mode::Composite:
      FillLayers(surfaces, low, high, colors, opacities);
      break;
    case Mode::MaximumIntensity:
      AddColor(colors, low, { 0.0, 0.0, 0.0 });
      AddColor(colors, high, { 1.0, 1.0, 1.0 });
      opacities->AddPoint(low, 0.0);
      opacities->AddPoint(high, 1.0);
      break;
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  property->SetShade(mode != Mode::MaximumIntensity);
  property->SetAmbient(0.16);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.22);
  property->SetSpecularPower(24.0);
  return property;
}

void SetMode(vtkVolumeMapper* mapper, Mode mode)
{
  switch (mode)
  {
    case Mode::IsoSurface:
      mapper->SetBlendModeToIsoSurface();
      break;
    case Mode::Composite:
      mapper->SetBlendModeToComposite();
      break;
    case Mode::MaximumIntensity:
      mapper->SetBlendModeToMaximumIntensity();
      break;
  }
}
