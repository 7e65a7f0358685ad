// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCShaderEdits
 * @brief   which text goes where in the shaders of VTK's volume ray caster
 *
 * The texts are those of vtkBCCVolumeShaderText; GLSL/README.md has a table of the tags.
 */

#ifndef vtkBCCShaderEdits_h
#define vtkBCCShaderEdits_h

#include "vtkBravaisABINamespace.h"
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkVolumeProperty;
struct vtkBCCShaderOptions;

struct vtkBCCShaderEdits
{
  /// Before VTK puts its own text at its tags.
  static void EditBefore(const vtkBCCShaderOptions& options, vtkGPUVolumeRayCastMapper* mapper,
    vtkVolumeProperty* property, std::string& geometry, std::string& fragment);

  /// After that, in a pass of vtkHardwareSelector.
  static void EditPicking(const vtkBCCShaderOptions& options, int pass, std::string& fragment);

  /// After it: statements of VTK's become calls of ours. `picking`: for a hardware selection. False
  /// if VTK's look-up is not found.
  static bool EditAfter(const vtkBCCShaderOptions& options, bool picking, std::string& fragment);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCShaderEdits.h
