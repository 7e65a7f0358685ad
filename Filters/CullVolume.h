// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CullVolume_h
#define CullVolume_h

#include "VolumeTest.h"
#include "vtkBravaisABINamespace.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkImplicitFunction;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// A volume in VTK's words, made ready for cells.
struct CullVolume
{
  /// What is asked about cells; nullptr where only gixels can be asked.
  std::unique_ptr<VolumeTest> Test;

  /// What is asked about gixels: negative inside. Where it is nullptr, Test is.
  vtkImplicitFunction* Function = nullptr;
};

/// vtkPlane, vtkPlanes, vtkBox and vtkSphere, with any affine transform, have a test of cells; all
/// others, and those with other transforms, none. False, with the reason, if the function is one
/// of these four and not properly set up.
bool MakeCullVolume(vtkImplicitFunction* function, CullVolume& volume, std::string& why);

/// What the camera sees, from the near to the far plane of its clipping range.
bool MakeCullVolume(vtkCamera* camera, double aspectRatio, CullVolume& volume, std::string& why);

} // namespace bravais

#endif
