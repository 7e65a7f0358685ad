// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeMask
 * @brief   where a point of a BCC volume is in a mask
 *
 * VTK looks up masks at the volume's texture coordinates, whatever their own geometry. Here a mask
 * that is tagged as a BCC volume, or has as many points along each axis as the volume, holds the
 * labels of lattice points: that of the nearest one counts. Any other mask is a Cartesian image of
 * labels at its points or in its cells, looked up where it lies; beyond it its border continues.
 */

#ifndef vtkBCCVolumeMask_h
#define vtkBCCVolumeMask_h

#include "vtkBravaisABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkMatrix4x4;
class vtkShaderProgram;
struct vtkBCCVolumeFrame;

struct vtkBCCVolumeMask
{
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
