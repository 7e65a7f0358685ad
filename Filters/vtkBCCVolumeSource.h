// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeSource
 * @brief   samples a known function on the body-centred cubic lattice
 *
 * The output is a vtkImageData that is tagged as a BCC volume (see vtkBCCLattice), with one
 * floating-point array `Scalars` as its scalars. The lattice fills the box `Bounds`, edge to edge:
 *
 *   s.x = (xmax - xmin) / (nx - 1/2),  s.y likewise,  s.z = (zmax - zmin) / (nk - 1),
 *
 * for `Dimensions` (nx, ny, nk), nk counting the layers of both cosets. It is isotropic when
 * s.x = s.y = 2 s.z; with the default cube, and many samples, nk = 2 nx is nearly so.
 *
 * The functions are evaluated in double precision at the points' world positions:
 *
 * - MarschnerLobb (the default): `Alpha` 0.25 and `Frequency` 6, made for the cube from -1 to 1.
 *   S. R. Marschner, R. J. Lobb, "An Evaluation of Reconstruction Filters for Volume Rendering",
 *   IEEE Visualization 1994.
 * - Sphere: the distance to the centre of `Bounds`.
 * - Gaussian: exp(-r^2 / (2 `StandardDeviation`^2)), r the distance to the centre of `Bounds`.
 * - Constant: `Value`.
 * - `ImplicitFunction`, when set, instead of any of these: any vtkImplicitFunction. These need not
 *   be safe to call from several threads, so it is evaluated in the calling thread alone.
 *
 * All else runs in parallel. A piece of the extent equals that piece of the whole.
 *
 * Errors, with an empty output: dimensions below 1 x 1 x 2 or more points than can be counted or
 * kept in memory, bounds that are not finite or not in ascending order, and a parameter of the
 * chosen function that is not finite, with Alpha at or below -1, or StandardDeviation at or below
 * 0.
 *
 * Example:
 * @code
 * source = vtkBCCVolumeSource()
 * source.SetDimensions(39, 39, 78)
 * source.Update()
 * volume = source.GetOutput()
 * @endcode
 *
 * @sa vtkBCCLattice vtkImageToBCCVolume
 */

#ifndef vtkBCCVolumeSource_h
#define vtkBCCVolumeSource_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For ImplicitFunction

#include <string> // For the checks' messages

VTK_ABI_NAMESPACE_BEGIN
class vtkImplicitFunction;

class VTKBRAVAIS_EXPORT vtkBCCVolumeSource : public vtkImageAlgorithm
{
public:
  static vtkBCCVolumeSource* New();
  vtkTypeMacro(vtkBCCVolumeSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Functions
  {
    MarschnerLobb,
    Sphere,
    Gaussian,
    Constant
  };

  ///@{
  /**
   * Points along x and y in a layer, and layers of both cosets together. Default 39, 39, 78; at
   * least 1, 1, 2.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The volume's box in the world: xmin, xmax, ymin, ymax, zmin, zmax. Default -1 to 1 on all axes.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * What is sampled, unless ImplicitFunction is set. Default MarschnerLobb.
   */
  vtkSetClampMacro(Function, int, MarschnerLobb, Constant);
  vtkGetMacro(Function, int);
  void SetFunctionToMarschnerLobb() { this->SetFunction(MarschnerLobb); }
  void SetFunctionToSphere() { this->SetFunction(Sphere); }
  void SetFunctionToGaussian() { this->SetFunction(Gaussian); }
  void SetFunctionToConstant() { this->SetFunction(Constant); }
  const char* GetFunctionAsString();
  ///@}

  ///@{
  /**
   * Amplitude of MarschnerLobb's ripples beside its slope along z. Default 0.25.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * Frequency of MarschnerLobb's ripples. Default 6.
   */
  vtkSetMacro(Frequency, double);
  vtkGetMacro(Frequency, double);
  ///@}

  ///@{
  /**
   * The Gaussian's standard deviation in world units. Default 0.3.
   */
  vtkSetMacro(StandardDeviation, double);
  vtkGetMacro(StandardDeviation, double);
  ///@}

  ///@{
  /**
   * The Constant's value. Default 1.
   */
  vtkSetMacro(Value, double);
  vtkGetMacro(Value, double);
  ///@}

  ///@{
  /**
   * A function of the world position to sample instead. Default none.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction();
  ///@}

  ///@{
  /**
   * VTK_FLOAT (the default) or VTK_DOUBLE.
   */
  vtkSetClampMacro(OutputScalarType, int, VTK_FLOAT, VTK_DOUBLE);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString();
  ///@}

  /**
   * The later of this object's time and the implicit function's.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkBCCVolumeSource();
  ~vtkBCCVolumeSource() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Dimensions[3] = { 39, 39, 78 };
  double Bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  int Function = MarschnerLobb;
  double Alpha = 0.25;
  double Frequency = 6.0;
  double StandardDeviation = 0.3;
  double Value = 1.0;
  int OutputScalarType = VTK_FLOAT;
  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;

private:
  vtkBCCVolumeSource(const vtkBCCVolumeSource&) = delete;
  void operator=(const vtkBCCVolumeSource&) = delete;

  bool CheckGeometry(std::string& why) const;
  bool CheckFunction(std::string& why) const;
  template <class T>
  bool Sample(vtkImageData* output);
};
VTK_ABI_NAMESPACE_END

#endif
