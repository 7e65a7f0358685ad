// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeRays
 * @brief   the rays of pixels through a volume, for the shader
 *
 * A ray is the line of the points of one pixel at all depths. A matrix takes pixels of the viewport
 * and depths to texture coordinates of the volume. It is computed in double precision, with depths
 * that count from the middle of the box on, so that its floats lose nothing far from the camera.
 */

#ifndef vtkBCCVolumeRays_h
#define vtkBCCVolumeRays_h

#include "vtkBravaisABINamespace.h"
#include "vtkNew.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

class vtkBCCVolumeRays
{
public:
  vtkBCCVolumeRays();
  ~vtkBCCVolumeRays();

  /// Rays of a viewport (x, y, width, height), seen by the renderer's camera, in the texture
  /// coordinates that these matrices take to the volume's own system and that to the world.
  void Compute(vtkRenderer* renderer, const int viewport[4], vtkMatrix4x4* textureToVolume,
    vtkMatrix4x4* volumeToWorld);

  /// The uniforms of bccPixelRay.glsl that say so.
  void SetUniforms(vtkShaderProgram* program) const;

  /// A rectangle of pixels of the viewport, x from 0 to 1 and y from 2 to 3, that the box is
  /// within.
  const std::array<double, 4>& GetBounds() const { return this->Bounds; }

private:
  void ComputeBounds(vtkMatrix4x4* textureToClip, const int viewport[4]);

  vtkNew<vtkMatrix4x4> PixelToTexture; // Both are transposed, as VTK passes matrices on.
  vtkNew<vtkMatrix4x4> TextureToClip;
  float Near = -1.0f;
  std::array<double, 4> Bounds{ { 0.0, 0.0, 0.0, 0.0 } };
  float Corner[2] = { 0.0f, 0.0f };
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeRays.h
