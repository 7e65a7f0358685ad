// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCRenderChecks
 * @brief   what VTK's ray caster would crash at, draw wrongly, or complain of in every frame
 *
 * The settings of a mapper and of a volume's property are looked at before VTK is given them.
 */

#ifndef vtkBCCRenderChecks_h
#define vtkBCCRenderChecks_h

#include "vtkBravaisABINamespace.h"
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkRenderer;
class vtkVolume;

struct vtkBCCRenderChecks
{
  /// Whether VTK can render a volume of one input; else tells why not.
  static bool Check(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, std::string& why);

  /// Whether the numbers of a jitter pattern and a progressive pattern's size are ones there are.
  static bool CheckPatterns(int jitter, int size, std::string& why);

  /// Whether there are rays, which take a sample and get on by steps: the distance between samples
  /// is a positive number that does not make too many of them.
  static bool CheckSampleDistances(
    vtkRenderer* renderer, vtkGPUVolumeRayCastMapper* mapper, double distance, std::string& why);

  /// The same as Check() for what depends on the components of the scalars, and on the lights.
  static bool CheckShading(
    vtkRenderer* renderer, vtkVolume* volume, int components, std::string& why);

  /// What VTK's shader depends on of the lights: 0 without any, 1 for one plain headlight, 2 for
  /// others, 3 if one has a position. Lights that are off count too, after one that is on or if
  /// they have a position.
  static int GetLightComplexity(vtkRenderer* renderer);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCRenderChecks.h
