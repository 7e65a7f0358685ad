// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCPictureState
 * @brief   all that the picture of a volume depends on, as numbers to be compared
 *
 * Times of modification where objects have one that tells what matters, and values where they are
 * set anew for every frame: matrices of the camera, and lights, which may follow it. What is in
 * front of the volume is not among them: see vtkBCCDepthWatch.
 */

#ifndef vtkBCCPictureState_h
#define vtkBCCPictureState_h

#include "vtkBravaisABINamespace.h"
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkGPUVolumeRayCastMapper;
class vtkRenderer;
class vtkVolume;

struct vtkBCCPictureState
{
  static std::vector<double> Get(
    vtkRenderer* renderer, vtkVolume* volume, vtkGPUVolumeRayCastMapper* mapper);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCPictureState.h
