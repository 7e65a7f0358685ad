// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCPrefilter
 * @brief   turns the samples of a BCC volume into spline coefficients
 *
 * A spline s(x) = sum_j c_j M(x - x_j) with the samples themselves as coefficients is too smooth.
 * This filter computes better ones for the kernel M that is to be used:
 *
 * - None: the samples.
 * - QuasiInterpolation: c_j = q0 f_j + q1 (sum of f over the 8 nearest neighbours of j), with q0,
 * q1 = 5/3, -1/12 for BCC7 and BCC8, 7/3, -1/6 for BCC12, 1, 0 for BCC4. The spline reproduces
 *   cubics (linear functions for BCC4), and its error falls as the fourth (second) power of the
 *   spacing. Local and fast.
 * - Interpolation: the spline passes through the samples. Only BCC4 and BCC8 can: the shifts of
 *   BCC7 and BCC12 are linearly dependent.
 * - Projection: the orthogonal projection of the band-limited signal onto the splines. The most
 *   accurate, by far, for volumes without noise near the sampling limit.
 *
 * Interpolation and Projection filter the whole volume by Fourier transforms; a frequency at which
 * no spline has any energy gets the coefficient 0. Beyond the volume's box samples are continued by
 * whole-sample mirrors. See Kim and Lee, Real-time BCC Volume Isosurface Ray Casting on the GPU,
 * section 3.2, and Documentation/references.md.
 *
 * Input: an image tagged as a BCC volume (vtkBCCLattice), any scalar type and number of components.
 * Output: the same lattice, its array (same name) in double where the input is double or a 64-bit
 * integer, else in float. Memory beside input and output: some lines a thread.
 *
 * Any piece equals that piece of the whole. Interpolation and Projection need the whole input for
 * it and compute all of it, once for all pieces: beside a piece the coefficients of the whole
 * volume are kept, until the input or a parameter changes or the piece with the volume's last point
 * has been put out. With ReleaseDataFlag on they are not kept, but computed anew for each piece. A
 * NaN spoils its neighbourhood under QuasiInterpolation, and its whole component under the other
 * two. Bad input (not tagged, fewer than two layers, BCC7 or BCC12 with Interpolation, samples so
 * large that coefficients are beyond float or double) gets one error and an empty output.
 *
 * Example:
 * @code
 * source = vtkBCCVolumeSource()
 * prefilter = vtkBCCPrefilter()
 * prefilter.SetInputConnection(source.GetOutputPort())
 * prefilter.SetMethodToProjection()
 * @endcode
 *
 * @sa vtkBCCVolumeToImage vtkBCCVolumeMapper
 */

#ifndef vtkBCCPrefilter_h
#define vtkBCCPrefilter_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For the coefficients that are kept

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class VTKBRAVAIS_EXPORT vtkBCCPrefilter : public vtkImageAlgorithm
{
public:
  static vtkBCCPrefilter* New();
  vtkTypeMacro(vtkBCCPrefilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    None = 0,
    QuasiInterpolation = 1,
    Interpolation = 2,
    Projection = 3
  };

  ///@{
  /**
   * How samples become coefficients. Default QuasiInterpolation.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToNone() { this->SetMethod(None); }
  void SetMethodToQuasiInterpolation() { this->SetMethod(QuasiInterpolation); }
  void SetMethodToInterpolation() { this->SetMethod(Interpolation); }
  void SetMethodToProjection() { this->SetMethod(Projection); }
  const char* GetMethodAsString();
  ///@}

  ///@{
  /**
   * The kernel that the coefficients are for, a constant of vtkBCCLattice. Default BCC7.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  void SetKernelToBCC4() { this->SetKernel(4); }
  void SetKernelToBCC7() { this->SetKernel(7); }
  void SetKernelToBCC8() { this->SetKernel(8); }
  void SetKernelToBCC12() { this->SetKernel(12); }
  const char* GetKernelAsString();
  ///@}

protected:
  vtkBCCPrefilter() = default;
  ~vtkBCCPrefilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Method = QuasiInterpolation;
  int Kernel = 7;

private:
  vtkBCCPrefilter(const vtkBCCPrefilter&) = delete;
  void operator=(const vtkBCCPrefilter&) = delete;

  /// The coefficients of a whole volume, and what they are of.
  struct Whole
  {
    vtkSmartPointer<vtkDataArray> Coefficients;
    vtkImageData* Input = nullptr; ///< to be compared, never used
    vtkMTimeType InputTime = 0;
    std::array<int, 6> Extent = {};
    int Method = None;
    int Kernel = 0;
  };
  Whole Kept;
  bool HasKept(vtkImageData* input, const std::array<int, 6>& extent) const;
};
VTK_ABI_NAMESPACE_END

#endif
