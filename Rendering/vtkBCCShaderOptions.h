// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCShaderOptions
 * @brief   what decides the text of vtkBCCVolumeMapper's shader
 *
 * VTK makes a shader anew when what it knows of changes; with these the mapper has it do so.
 */

#ifndef vtkBCCShaderOptions_h
#define vtkBCCShaderOptions_h

#include "BCCKernel.h"
#include "vtkBCCBrickTexture.h"
#include "vtkBravaisABINamespace.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCVolumeInput;
class vtkBCCVolumeMapper;
class vtkRenderer;
class vtkVolume;

struct vtkBCCShaderOptions
{
  /// Those of a mapper that is to render this input; BayerJitter and Progressive are the caller's.
  static vtkBCCShaderOptions Collect(
    vtkBCCVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, vtkBCCVolumeInput& input);

  /// Whether another pass, or who asked to keep OpenGL's state, decides on the depth buffer.
  static bool IsDepthTaken(vtkVolume* volume);

  bool operator==(const vtkBCCShaderOptions& other) const;

  bravais::BCCKernel Kernel = bravais::BCCKernel::BCC7;
  bool AnalyticGradients = true;
  bool RefineRoots = false; // isosurface blending only
  bool WriteDepth = false;  // of refined roots
  bool BayerJitter = false;
  vtkBCCBrickTexture::Rule SkipRule = vtkBCCBrickTexture::Nothing;
  bool PixelRays = true; // if not, as VTK interpolates them
  bool Progressive = false;
  bool Piece = false; // of a volume
  // Of these VTK takes no notice by itself:
  int LightComplexity = 0;
  int Mask = -1; // its type, or -1
  bool LatticeMask = false;
  std::size_t UserHash = 0;
  bool HalfFloats = false;
  bool Buffer = false; // coefficients are in a buffer instead of a 3D texture
  int Components = 1;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCShaderOptions.h
