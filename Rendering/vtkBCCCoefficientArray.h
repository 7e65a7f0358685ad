// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCCoefficientArray
 * @brief   what VTK is told of a BCC volume's values without being given them
 *
 * VTK's ray caster makes a texture from an array and takes the range of the transfer functions
 * from it. This array tells the range of a volume's samples, which its spline coefficients may
 * exceed, and has no values: vtkBCCVolumeShaderStage fills the texture that VTK makes.
 */

#ifndef vtkBCCCoefficientArray_h
#define vtkBCCCoefficientArray_h

#include "vtkBravaisABINamespace.h"
#include "vtkFloatArray.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class vtkBCCCoefficientArray : public vtkFloatArray
{
public:
  static vtkBCCCoefficientArray* New();
  vtkTypeMacro(vtkBCCCoefficientArray, vtkFloatArray);

  /// Takes the component count and the finite ranges of an array of an image, those that are
  /// noted for the whole volume if it is a piece. False if a component has no finite value.
  bool Describe(vtkDataArray* samples, vtkImageData* image);

protected:
  vtkBCCCoefficientArray() = default;
  ~vtkBCCCoefficientArray() override = default;

  bool ComputeScalarRange(double* ranges) override;
  bool ComputeFiniteScalarRange(double* ranges) override;

private:
  vtkBCCCoefficientArray(const vtkBCCCoefficientArray&) = delete;
  void operator=(const vtkBCCCoefficientArray&) = delete;

  std::vector<double> Ranges;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCCoefficientArray.h
