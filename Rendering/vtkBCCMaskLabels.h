// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCMaskLabels
 * @brief   labels of a mask in a type that textures hold as they are
 *
 * VTK stretches the values of a mask from their least to their largest over all labels that the
 * property has functions for, stretches those of some types twice, and cannot load others. Here
 * unsigned chars, unsigned shorts and floats are kept, others copied to floats, and the shader
 * makes labels of texels by a factor.
 */

#ifndef vtkBCCMaskLabels_h
#define vtkBCCMaskLabels_h

#include "vtkBravaisABINamespace.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class vtkBCCMaskLabels
{
public:
  vtkBCCMaskLabels();
  ~vtkBCCMaskLabels();
  vtkBCCMaskLabels(const vtkBCCMaskLabels&) = delete;
  void operator=(const vtkBCCMaskLabels&) = delete;

  /// The mask, which may be null and else has scalars, or a copy of it as floats that is kept.
  vtkImageData* GetLoadable(vtkImageData* mask);

  /// What texels of such a mask are multiplied by.
  static float GetFactor(vtkImageData* mask);

private:
  vtkSmartPointer<vtkImageData> Copy;
  vtkWeakPointer<vtkImageData> Source; // of the copy
  vtkMTimeType Time = 0;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCMaskLabels.h
