// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCInterpolator
 * @brief   lets VTK's image filters sample a BCC volume
 *
 * A vtkAbstractImageInterpolator for images tagged as BCC volumes (vtkBCCLattice): vtkImageReslice,
 * vtkImageResliceMapper, vtkImageSlabReslice and others that take an interpolator then sample the
 * spline of `Kernel` with coefficients by `Prefilter`, as vtkBCCVolumeToImage does. Structured
 * coordinates are VTK's, (x - origin) / spacing: the volume's box reaches to half a spacing beyond
 * the last index along x and y, and all of it can be sampled.
 *
 * Points are looked up in double arithmetic, from any number of threads. BorderMode tells what
 * points beyond the box give, as far as Tolerance lets them: Clamp the nearest point of the box,
 * Mirror the mirrored point, Repeat the point a box further; the spline itself is continued by
 * whole-sample mirrors.
 *
 * Initialize() computes the coefficients (float, double for double and 64-bit integers) and they
 * are kept until the image, kernel or prefilter changes, so that one volume can be resliced many
 * times. That is the memory it takes. A volume without tag or with fewer than two layers, and
 * BCC7 or BCC12 with Interpolation, get one error, and every point is then out of bounds.
 *
 * VTK's filters pass the field data of their input on, the tag too, though what they make by this
 * interpolator is a Cartesian image: remove the array `Lattice` from it.
 *
 * Example:
 * @code
 * source = vtkBCCVolumeSource()
 * reslice = vtkImageReslice()
 * reslice.SetInputConnection(source.GetOutputPort())
 * reslice.SetInterpolator(vtkBCCInterpolator())
 * @endcode
 *
 * @sa vtkBCCVolumeToImage
 */

#ifndef vtkBCCInterpolator_h
#define vtkBCCInterpolator_h

#include "vtkAbstractImageInterpolator.h"
#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <memory> // For the coefficients

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkBCCInterpolator : public vtkAbstractImageInterpolator
{
public:
  static vtkBCCInterpolator* New();
  vtkTypeMacro(vtkBCCInterpolator, vtkAbstractImageInterpolator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The spline's kernel, a constant of vtkBCCLattice. Default BCC7. Call Update() after a change.
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
   * (3). Call Update() after a change.
   */
  vtkSetMacro(Prefilter, int);
  vtkGetMacro(Prefilter, int);
  void SetPrefilterToNone() { this->SetPrefilter(0); }
  void SetPrefilterToQuasiInterpolation() { this->SetPrefilter(1); }
  void SetPrefilterToInterpolation() { this->SetPrefilter(2); }
  void SetPrefilterToProjection() { this->SetPrefilter(3); }
  const char* GetPrefilterAsString();
  ///@}

  /**
   * Copies all settings of another interpolator, its volume and its coefficients, which the two
   * then share. Call Update() before the copy is used. (VTK's own copies no more than the settings
   * of vtkAbstractImageInterpolator.)
   */
  void DeepCopy(vtkAbstractImageInterpolator* other);

  /**
   * Takes the volume to sample.
   */
  void Initialize(vtkDataObject* data) override;

  /**
   * The samples that a point depends on: 8 along x and y, 12 along z; all for the prefilters
   * Interpolation and Projection.
   */
  void ComputeSupportSize(const double matrix[16], int support[3]) override;

  /**
   * False: the box-splines are no products.
   */
  bool IsSeparable() override { return false; }

protected:
  vtkBCCInterpolator() = default;
  ~vtkBCCInterpolator() override;

  void InternalUpdate() override;
  void InternalDeepCopy(vtkAbstractImageInterpolator* other) override;
  void GetInterpolationFunc(
    void (**function)(vtkInterpolationInfo*, const double[3], double*)) override;
  void GetInterpolationFunc(
    void (**function)(vtkInterpolationInfo*, const float[3], float*)) override;

  int Kernel = 7;
  int Prefilter = 1;

private:
  vtkBCCInterpolator(const vtkBCCInterpolator&) = delete;
  void operator=(const vtkBCCInterpolator&) = delete;

  class Coefficients;
  bool Prepare();
  void SetEmptyBounds();

  std::shared_ptr<const Coefficients> Cache;
};
VTK_ABI_NAMESPACE_END

#endif
