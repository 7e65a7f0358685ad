// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeMask
 * @brief   where a point of a BCC volume is in a mask
 *
 * VTK looks up masks at the volume's texture coordinates, whatever their own geometry. Here a mask
 * that is tagged as a BCC volume, or has as many points along each axis as the volume, holds the
 * labels of lattice points: that of the nearest one counts. Any other mask is a Cartesian image of
 * labels at its points or in its cells, looked up where it lies. Its border continues by a lattice
 * unit of the volume, half a spacing; beyond that there are no labels.
 */

#ifndef vtkBCCVolumeMask_h
#define vtkBCCVolumeMask_h

#include "vtkBravaisABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkImageData;
class vtkShaderProgram;
class vtkVolumeProperty;
struct vtkBCCVolumeFrame;

struct vtkBCCVolumeMask
{
  /// Whether there is a mask that matters: VTK colours by labels in composite blending, of scalars
  /// of one component.
  static bool IsUsed(vtkGPUVolumeRayCastMapper* mapper, int components);

  /// Whether VTK can render the mask: it has no text for labels of several independent components.
  static bool Check(vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, int components,
    std::string& why);

  /// Tells VTK, which looks at the property's time alone, that functions of labels have changed.
  static void NoticeFunctions(vtkVolumeProperty* property);

  /// Whether a mask has its labels on lattice points, those of a volume or its own.
  static bool IsLattice(vtkImageData* mask, const vtkBCCVolumeFrame& held);

  /// Sets what bccMask.glsl needs. The stand-in has the volume's box; `held` are the samples of it
  /// that there are, in its lattice coordinates: all, or a piece's.
  static void SetUniforms(vtkShaderProgram* program, vtkImageData* mask,
    const vtkBCCVolumeFrame& volume, const vtkBCCVolumeFrame& held, vtkImageData* standIn);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeMask.h
