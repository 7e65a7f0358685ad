// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeRays.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

vtkBCCVolumeRays::vtkBCCVolumeRays() = default;
vtkBCCVolumeRays::~vtkBCCVolumeRays() = default;

//------------------------------------------------------------------------------
void vtkBCCVolumeRays::ComputeBounds(vtkMatrix4x4* textureToClip, const int viewport[4])
{
  const double size[2] = { static_cast<double>(viewport[2]), static_cast<double>(viewport[3]) };
  this->Bounds = { { size[0], 0.0, size[1], 0.0 } };
  for (int corner = 0; corner < 8; ++corner)
  {
    double clip[4];
    for (int i = 0; i < 4; ++i)
    {
      clip[i] = textureToClip->GetElement(3, i);
      for (int axis = 0; axis < 3; ++axis)
      {
        clip[i] += (corner >> axis) & 1 ? textureToClip->GetElement(axis, i) : 0.0;
      }
    }
    if (!(clip[3] > 0.0))
    {
      this->Bounds = { { 0.0, size[0], 0.0, size[1] } }; // Part of the box is behind the camera.
      return;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const double pixel =
        std::min(std::max(0.5 * (clip[axis] / clip[3] + 1.0), 0.0), 1.0) * size[axis];
      this->Bounds[2 * axis] = std::min(this->Bounds[2 * axis], pixel);
      this->Bounds[2 * axis + 1] = std::max(this->Bounds[2 * axis + 1], pixel);
    }
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRays::Compute(vtkRenderer* renderer, const int viewport[4],
  vtkMatrix4x4* textureToVolume, vtkMatrix4x4* volumeToWorld)
{
  vtkMatrix4x4* worldToView = nullptr;
  vtkMatrix4x4* viewToClip = nullptr;
  vtkMatrix4x4* worldToClip = nullptr; // transposed, as all that VTK keeps for shaders
  vtkMatrix3x3* normals = nullptr;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  vtkMatrix4x4* textureToClip = this->TextureToClip;
  vtkMatrix4x4::Multiply4x4(volumeToWorld, textureToVolume, textureToClip);
  textureToClip->Transpose();
  vtkMatrix4x4::Multiply4x4(textureToClip, worldToClip, textureToClip);

  this->ComputeBounds(textureToClip, viewport);

  // The depth of the box's middle, if that is before the camera.
  double middle[4];
  for (int i = 0; i < 4; ++i)
  {
    middle[i] = textureToClip->GetElement(3, i);
    for (int axis = 0; axis < 3; ++axis)
    {
      middle[i] += 0.5 * textureToClip->GetElement(axis, i);
    }
  }
  const double depth =
    middle[3] > 0.0 ? std::min(std::max(middle[2] / middle[3], -1.0), 1.0) : -1.0;

  vtkNew<vtkMatrix4x4> pixelToClip;
  pixelToClip->SetElement(0, 0, 2.0 / viewport[2]);
  pixelToClip->SetElement(1, 1, 2.0 / viewport[3]);
  pixelToClip->SetElement(3, 0, -1.0);
  pixelToClip->SetElement(3, 1, -1.0);
  pixelToClip->SetElement(3, 2, depth);
  vtkNew<vtkMatrix4x4> clipToTexture;
  vtkMatrix4x4::Invert(textureToClip, clipToTexture);
  vtkMatrix4x4::Multiply4x4(pixelToClip, clipToTexture, this->PixelToTexture);

  // Homogeneous coordinates may have any factor: one that floats can hold.
  double* entries = this->PixelToTexture->GetData();
  double largest = 0.0;
  std::for_each(entries, entries + 16, [&](double e) { largest = std::max(largest, std::abs(e)); });
  std::for_each(entries, entries + 16, [&](double& e) { e /= largest > 0.0 ? largest : 1.0; });

  // VTK cuts the box a thousandth of the depth range behind the near plane.
  double range[2];
  renderer->GetActiveCamera()->GetClippingRange(range);
  double near[4] = { 0.0, 0.0, -(range[0] + 0.001 * (range[1] - range[0])), 1.0 };
  vtkNew<vtkMatrix4x4> clip;
  clip->DeepCopy(viewToClip);
  clip->Transpose();
  clip->MultiplyPoint(near, near);
  this->Near = static_cast<float>(near[2] / near[3] - depth);
  this->Corner[0] = static_cast<float>(viewport[0]);
  this->Corner[1] = static_cast<float>(viewport[1]);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRays::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformMatrix("in_bccRay", this->PixelToTexture.Get());
  program->SetUniformMatrix("in_bccToClip", this->TextureToClip.Get());
  program->SetUniformf("in_bccNear", this->Near);
  program->SetUniform2f("in_bccCorner", this->Corner);
}
