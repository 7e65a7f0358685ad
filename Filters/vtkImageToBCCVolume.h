// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageToBCCVolume
 * @brief   turns a Cartesian volume into one on the body-centred cubic lattice
 *
 * The input is an ordinary three-dimensional vtkImageData of any scalar type and number of
 * components, the output one that is tagged as a BCC volume (see vtkBCCLattice), in the same place
 * of the world: the input's direction matrix is kept, as are its field data.
 *
 * `Mode` Subset keeps the points whose three indices, counted from the first point of the input's
 * whole extent, are all even or all odd. All point arrays are copied bit for bit. Of Nx x Ny x Nz
 * points remain floor(Nx/2) x floor(Ny/2) x Nz, with spacing (2 s.x, 2 s.y, s.z) and the origin at
 * the input's first point. Only the extent that an output piece comes from is asked for.
 *
 * `Mode` Resample (the default) interpolates the input's scalars on an isotropic lattice, spacing
 * (2a, 2a, a), whatever the input's spacing:
 *
 * - Without `Dimensions` the number of points is as near as can be to `SampleRatio` times the
 *   input's. With `Dimensions` (nx, ny, nk) it is theirs. In both cases a is the largest for which
 *   the lattice's box is not larger than the box of the input's points, and the two boxes have one
 *   centre, so nothing is extrapolated. Without Dimensions less than one step is left over along
 *   any axis; dimensions of another shape than the input's box leave more of it out.
 * - `Interpolator` is any vtkAbstractImageInterpolator, by default a cubic
 *   vtkImageBSplineInterpolator that mirrors the borders. For B-splines of any degree the
 *   coefficients are computed here, so the input has to be samples. The one given is not changed.
 * - `LowPass` (on) removes, before decimation, the frequencies that the lattice cannot represent:
 *   those beyond the Voronoi cell of its dual, the rhombic dodecahedron
 *   max(|f.x| + |f.y|, |f.x| + |f.z|, |f.y| + |f.z|) <= 1 / (2a), which along an axis reaches to
 *   1 / (2a). The gain is 1 up to 0.8 of that and falls smoothly to 0 (see BCCLowPass.h). There is
 *   decimation if the lattice has fewer points per volume than the input (4 a^3 > h.x h.y h.z for
 *   spacing h) or a is more than the input's spacing along an axis; without, the input is
 *   interpolated as it is. Turn it off for labels.
 * - The output's scalars keep the input's type and name. Arithmetic is in double; the filtered
 *   samples and the coefficients are kept as float, for double and 64-bit integers as double.
 *   Integers are rounded and clamped to their range.
 *
 * B-spline coefficients and the low-pass depend on all samples: both ask for the whole input and
 * hold a floating-point copy of it meanwhile, the low-pass of several components one component
 * more. Other interpolators get an output piece from the input that its kernel reaches. In every
 * case a piece equals that piece of the whole, and threads make no difference. NaN spreads as far
 * as the kernel reaches, which is everywhere for B-splines and the low-pass.
 *
 * Errors, with an empty output: an input that is tagged as BCC or rank-1, has no point scalars,
 * point arrays of fewer tuples than points, fewer than two points along an axis, or a spacing or
 * origin that is not finite (or spacing not positive); scalars to resample that are no numbers of 8
 * to 64 bits; a SampleRatio that is not positive and finite or gives less than 1 x 1 x 2 points;
 * Dimensions that are neither 0, 0, 0 nor at least 1, 1, 2; no Interpolator, or one for BCC
 * volumes; more points than can be counted or kept in memory.
 *
 * Example:
 * @code
 * to_bcc = vtkImageToBCCVolume()
 * to_bcc.SetInputConnection(reader.GetOutputPort())
 * to_bcc.Update()
 * @endcode
 *
 * @sa vtkBCCLattice vtkBCCVolumeToImage vtkImageReslice
 */

#ifndef vtkImageToBCCVolume_h
#define vtkImageToBCCVolume_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For Interpolator

#include <string> // For the checks' messages

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractImageInterpolator;
VTK_ABI_NAMESPACE_END

namespace bravais
{
struct BCCPlacement;
struct ImageGrid;
}

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkImageToBCCVolume : public vtkImageAlgorithm
{
public:
  static vtkImageToBCCVolume* New();
  vtkTypeMacro(vtkImageToBCCVolume, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    Subset,
    Resample
  };

  ///@{
  /**
   * Whether points are kept or made anew. Default Resample.
   */
  vtkSetClampMacro(Mode, int, Subset, Resample);
  vtkGetMacro(Mode, int);
  void SetModeToSubset() { this->SetMode(Subset); }
  void SetModeToResample() { this->SetMode(Resample); }
  const char* GetModeAsString();
  ///@}

  ///@{
  /**
   * For Resample: points along x and y in a layer, and layers of both cosets together. Default
   * 0, 0, 0, which leaves the choice to SampleRatio.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * For Resample without Dimensions: BCC samples per input sample. Default 1.
   */
  vtkSetMacro(SampleRatio, double);
  vtkGetMacro(SampleRatio, double);
  ///@}

  ///@{
  /**
   * For Resample: what the input's values between its points are. Default cubic B-spline.
   */
  virtual void SetInterpolator(vtkAbstractImageInterpolator* interpolator);
  vtkAbstractImageInterpolator* GetInterpolator();
  ///@}

  ///@{
  /**
   * For Resample: whether decimation is preceded by a low-pass. Default on.
   */
  vtkSetMacro(LowPass, bool);
  vtkGetMacro(LowPass, bool);
  vtkBooleanMacro(LowPass, bool);
  ///@}

  /**
   * The later of this object's time and the interpolator's.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkImageToBCCVolume();
  ~vtkImageToBCCVolume() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Mode = Resample;
  int Dimensions[3] = { 0, 0, 0 };
  double SampleRatio = 1.0;
  bool LowPass = true;
  vtkSmartPointer<vtkAbstractImageInterpolator> Interpolator;

private:
  vtkImageToBCCVolume(const vtkImageToBCCVolume&) = delete;
  void operator=(const vtkImageToBCCVolume&) = delete;

  bool CheckParameters(bool blocks, std::string& why) const;
  bool Place(vtkInformation* inInfo, bravais::ImageGrid& grid, bravais::BCCPlacement& placement,
    std::string& why) const;
  bool NeedsWholeInput(const bravais::BCCPlacement& placement) const;
  void GetInputExtent(const bravais::ImageGrid& grid, const bravais::BCCPlacement& placement,
    const int extent[6], int inExtent[6]) const;
  bool ResampleScalars(
    vtkImageData* input, const bravais::BCCPlacement& placement, vtkImageData* output);
  int Fail(vtkInformationVector* outputVector, const std::string& why);
};
VTK_ABI_NAMESPACE_END

#endif
