// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Appearance_h
#define Appearance_h

/// \file
/// How a volume looks: its colours, opacities and shading.

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkVolumeMapper;
class vtkVolumeProperty;

enum class Mode
{
  IsoSurface,
  Composite,
  MaximumIntensity
};

/// A value of the volume that is to be seen, and how.
struct Surface
{
  double Value;
  std::array<double, 3> Color;
  double Opacity;
};

/// Surfaces at some values: colours from skin to bone, only the highest value opaque.
std::vector<Surface> MakeSurfaces(std::vector<double> values);

/// In Mode IsoSurface the surfaces; in Composite layers that rise at their values and stay;
/// in MaximumIntensity greys from low to high. Opacities are per unitDistance.
vtkSmartPointer<vtkVolumeProperty> MakeAppearance(
  Mode mode, const std::vector<Surface>& surfaces, double low, double high, double unitDistance);

void SetMode(vtkVolumeMapper* mapper, Mode mode);

#endif
