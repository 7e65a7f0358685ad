// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCPieceSampling
 * @brief   where a piece of a volume is sampled, and how far beyond it that reaches
 *
 * VTK's ray caster takes the distance of samples from its input. Of a piece that is a stand-in that
 * is not divided into cells (vtkBCCVolumePiece), so the distance is found here, as VTK would find
 * it from the whole's. Look-ups reach beyond the piece by the kernel, by the differences that take
 * the place of gradients, and by the samples before and after it that tell of surfaces.
 */

#ifndef vtkBCCPieceSampling_h
#define vtkBCCPieceSampling_h

#include "vtkBravaisABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCVolumeMapper;
class vtkMatrix4x4;

struct vtkBCCPieceSampling
{
  /// The sample distance of the mapper's settings, in the world that a matrix takes the volume to,
  /// for a stand-in of such cells; `locked` is what VTK adjusts to these.
  static float FindDistance(
    vtkBCCVolumeMapper* mapper, const double spacing[3], vtkMatrix4x4* matrix, double locked);

  /// How many lattice units along each axis look-ups reach, for samples at a distance.
  static void FindReach(vtkBCCVolumeMapper* mapper, const double latticePerUnit[3], double distance,
    bool surfaces, int reach[3]);

  /// vtkBCCVolumeMapper::GetNumberOfGhostLevels().
  static int GetNumberOfGhostLevels(
    vtkBCCVolumeMapper* mapper, const double spacing[3], double scale);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCPieceSampling.h
