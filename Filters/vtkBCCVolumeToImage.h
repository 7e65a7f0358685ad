// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeToImage
 * @brief   samples the spline of a BCC volume on a Cartesian grid
 *
 * The input's samples become the coefficients of a spline of `Kernel` by `Prefilter`, and the
 * spline
 *
 *   s(x) = sum_j c_j M(x - x_j)
 *
 * is evaluated at `OutputDimensions` points that span the volume's box (vtkBCCLattice::GetBox)
 * from face to face. See Kim and Lee, Real-time BCC Volume Isosurface Ray Casting on the GPU, and
 * vtkBCCPrefilter. Beyond the box the volume is continued by whole-sample mirrors.
 *
 * Input: an image tagged as a BCC volume (vtkBCCLattice), any scalar type and number of components.
 * Output: an image with the same array name and components, in the input's type unless
 * OutputScalarType says otherwise; integers are rounded and clamped. With ComputeGradients there is
 * also the point array `Gradients`: the derivatives of the same spline along x, y, z of the world,
 * in scalar units per world unit, 3 numbers for each component, as float or double. Arithmetic is
 * in double where the input is double or a 64-bit integer, else in float.
 *
 * Memory: beside input and output, at most a tenth of both, or ten layers of the input where that
 * is more. Interpolation and Projection are filters of the whole volume, and hold its coefficients
 * as well.
 *
 * Any piece of the output equals that piece of the whole. Bad input (not tagged, fewer than two
 * layers, negative dimensions, BCC7 or BCC12 with Interpolation) gets one error and an empty
 * output.
 *
 * Example:
 * @code
 * source = vtkBCCVolumeSource()
 * image = vtkBCCVolumeToImage()
 * image.SetInputConnection(source.GetOutputPort())
 * image.SetOutputDimensions(128, 128, 128)
 * @endcode
 *
 * @sa vtkBCCPrefilter vtkBCCInterpolator vtkImageToBCCVolume
 */

#ifndef vtkBCCVolumeToImage_h
#define vtkBCCVolumeToImage_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkBCCVolumeToImage : public vtkImageAlgorithm
{
public:
  static vtkBCCVolumeToImage* New();
  vtkTypeMacro(vtkBCCVolumeToImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of points along x, y and z. They span the box from face to face; a single point lies in
   * its middle. 0, the default, stands for the number that makes the spacing the input's along z,
   * or as near to it as spanning the box allows (it is exact on an isotropic lattice).
   */
  vtkSetVector3Macro(OutputDimensions, int);
  vtkGetVector3Macro(OutputDimensions, int);
  ///@}

  ///@{
  /**
   * The spline's kernel, a constant of vtkBCCLattice. Default BCC7.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  void SetKernelToBCC4() { this->SetKernel(4); }
  void SetKernelToBCC7() { this->SetKernel(7); }
  void SetKernelToBCC8() { this->SetKernel(8); }
  void SetKernelToBCC12() { this->SetKernel(12); }
  const char* GetKernelAsString();
  ///@}

  ///@{
  /**
   * How samples become coefficients, one of vtkBCCPrefilter's methods: None (0), for an input that
   * already holds coefficients, QuasiInterpolation (1, the default), Interpolation (2), Projection
   * (3).
   */
  vtkSetMacro(Prefilter, int);
  vtkGetMacro(Prefilter, int);
  void SetPrefilterToNone() { this->SetPrefilter(0); }
  void SetPrefilterToQuasiInterpolation() { this->SetPrefilter(1); }
  void SetPrefilterToInterpolation() { this->SetPrefilter(2); }
  void SetPrefilterToProjection() { this->SetPrefilter(3); }
  const char* GetPrefilterAsString();
  ///@}

  ///@{
  /**
   * Whether the array Gradients is made. Default off.
   */
  vtkSetMacro(ComputeGradients, bool);
  vtkGetMacro(ComputeGradients, bool);
  vtkBooleanMacro(ComputeGradients, bool);
  ///@}

  ///@{
  /**
   * Scalar type of the output, a VTK constant as VTK_FLOAT. Default -1, the input's;
   * its text is then "input".
   */
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString();
  ///@}

protected:
  vtkBCCVolumeToImage() = default;
  ~vtkBCCVolumeToImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int OutputDimensions[3] = { 0, 0, 0 };
  int Kernel = 7;
  int Prefilter = 1;
  bool ComputeGradients = false;
  int OutputScalarType = -1;

private:
  vtkBCCVolumeToImage(const vtkBCCVolumeToImage&) = delete;
  void operator=(const vtkBCCVolumeToImage&) = delete;

  bool CheckParameters(bool blocks, std::string& why) const;
};
VTK_ABI_NAMESPACE_END

#endif
