// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1ImageReconstruct
 * @brief   a rank-1 image on a Cartesian grid of pixels
 *
 * Input: a rank-1 image (vtkRank1ImageResample), any scalar type and number of components. Output:
 * a picture of `OutputDimensions` pixels that cover the input's domain from edge to edge, in the
 * same type. Each pixel is the mean of `SamplesPerAxis` squared look-ups, evenly spread over the
 * pixel; one is at its centre. See Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1
 * Lattices, sections 4.1 and 5.1.
 *
 * `Interpolation` Nearest takes the texel whose Voronoi cell the point is in. Bilinear is that of
 * the four corners of the fundamental parallelepiped, Barycentric that of the three corners of the
 * Delaunay triangle: both continuous, exact for linear functions, and through the texels. BoxSpline
 * has the texels as the coefficients of the three-direction quartic box-spline: twice continuously
 * differentiable and smoothing, exact for linear functions too. Tiles go over into each other, and
 * the picture as a whole is periodic.
 *
 * Arithmetic is in double precision; integers are rounded and clamped. Any piece equals that piece
 * of the whole, and needs the whole input: since the domain is known only with the data, the input
 * is updated when information is asked for. The filter allocates nothing beside its output.
 *
 * Errors, with an empty output: an input that is not tagged as a rank-1 image, or whose marks and
 * dimensions contradict each other, no point scalars, negative dimensions, samples below 1 or above
 * 256, and an output beyond the machine's memory.
 *
 * Example:
 * @code
 * image = vtkRank1ImageReconstruct()
 * image.SetOutputDimensions(512, 512)
 * image.SetInputConnection(rank1.GetOutputPort())
 * image.Update()
 * @endcode
 *
 * @sa vtkRank1ImageResample vtkRank1ImageToPolyData
 */

#ifndef vtkRank1ImageReconstruct_h
#define vtkRank1ImageReconstruct_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkRank1ImageReconstruct : public vtkImageAlgorithm
{
public:
  static vtkRank1ImageReconstruct* New();
  vtkTypeMacro(vtkRank1ImageReconstruct, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Interpolations
  {
    Nearest,
    Bilinear,
    Barycentric,
    BoxSpline
  };

  ///@{
  /**
   * Width and height in pixels. A 0 stands for square pixels, two for about as many as texels.
   * Default 0, 0.
   */
  vtkSetVector2Macro(OutputDimensions, int);
  vtkGetVector2Macro(OutputDimensions, int);
  ///@}

  ///@{
  /**
   * What is between the texels. Default Barycentric.
   */
  vtkSetClampMacro(Interpolation, int, Nearest, BoxSpline);
  vtkGetMacro(Interpolation, int);
  void SetInterpolationToNearest() { this->SetInterpolation(Nearest); }
  void SetInterpolationToBilinear() { this->SetInterpolation(Bilinear); }
  void SetInterpolationToBarycentric() { this->SetInterpolation(Barycentric); }
  void SetInterpolationToBoxSpline() { this->SetInterpolation(BoxSpline); }
  const char* GetInterpolationAsString();
  ///@}

  ///@{
  /**
   * Look-ups along each side of a pixel, 1 to 256. Default 1.
   */
  vtkSetMacro(SamplesPerAxis, int);
  vtkGetMacro(SamplesPerAxis, int);
  ///@}

protected:
  vtkRank1ImageReconstruct() = default;
  ~vtkRank1ImageReconstruct() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRank1ImageReconstruct(const vtkRank1ImageReconstruct&) = delete;
  void operator=(const vtkRank1ImageReconstruct&) = delete;

  bool CheckParameters(bool blocks, std::string& why) const;

  int OutputDimensions[2] = { 0, 0 };
  int Interpolation = Barycentric;
  int SamplesPerAxis = 1;
};
VTK_ABI_NAMESPACE_END

#endif
