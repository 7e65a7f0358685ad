// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOrderedDither
 * @brief   quantises an image or volume to a few levels by a Bayer pattern
 *
 * A scalar v is u = (v - lo) / (hi - lo) (L - 1) levels, with `InputRange` lo .. hi and
 * `NumberOfLevels` L. The output, unsigned char, is the level below u, or the next one where the
 * fraction of u reaches the threshold (rank + 1/2) / cells of the point's cell, its rank being that
 * of vtkBayerPattern. The levels are 0 .. L - 1, and level l stands for lo + l (hi - lo) / (L - 1),
 * so a constant keeps its mean to half a threshold, and a slope has no bands.
 *
 * `Dimensionality` 2 repeats a square pattern in every slice, x and y; 3 has a cube of thresholds,
 * so that slices of all directions, and averages over depth such as a volume rendering makes, keep
 * their means too. The pattern is anchored at index 0 of the whole extent, so a piece equals that
 * piece of the whole. All components of a point have the same threshold.
 *
 * Any scalar type and number of components. Numbers beyond the range get the first or the last
 * level, and NaN gets level 0. Arithmetic is in double precision. Other arrays are passed on.
 * With `InputRange` (0, 0) the range is that of the input's finite scalars, of all components
 * together, and the whole input is then asked for whatever piece is made.
 *
 * Errors, with an empty output: a number of levels below 2 or above 256, a range that is empty,
 * not in ascending order or not finite (a constant input has an empty scalar range: set
 * InputRange), a log2 size below 0 or above 22 / Dimensionality, no points, no point scalars, and
 * a scalar type that VTK has no images of.
 *
 * Example:
 * @code
 * dither = vtkOrderedDither()
 * dither.SetNumberOfLevels(4)
 * dither.SetInputConnection(reader.GetOutputPort())
 * dither.Update()
 * @endcode
 *
 * @sa vtkBayerPattern vtkLookupTable
 */

#ifndef vtkOrderedDither_h
#define vtkOrderedDither_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string> // For the checks' messages

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class VTKBRAVAIS_EXPORT vtkOrderedDither : public vtkImageAlgorithm
{
public:
  static vtkOrderedDither* New();
  vtkTypeMacro(vtkOrderedDither, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BaseOrders
  {
    FCC,
    BCC
  };

  ///@{
  /**
   * How many levels the output has, 2 to 256. Default 2.
   */
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Whether the pattern is a square, 2, or a cube, 3. Default 2.
   */
  vtkSetMacro(Dimensionality, int);
  vtkGetMacro(Dimensionality, int);
  ///@}

  ///@{
  /**
   * Binary logarithm of the pattern's side, 0 to 11 for a square and 0 to 7 for a cube. A side of 1
   * rounds to the nearest level. Default 3: 8 points.
   */
  vtkSetMacro(PatternLog2Size, int);
  vtkGetMacro(PatternLog2Size, int);
  ///@}

  ///@{
  /**
   * The base order of cubes, see vtkBayerPattern. Default FCC.
   */
  vtkSetClampMacro(BaseOrder, int, FCC, BCC);
  vtkGetMacro(BaseOrder, int);
  void SetBaseOrderToFCC() { this->SetBaseOrder(FCC); }
  void SetBaseOrderToBCC() { this->SetBaseOrder(BCC); }
  const char* GetBaseOrderAsString();
  ///@}

  ///@{
  /**
   * The numbers that become the first and the last level. Default 0, 0: the scalar range.
   */
  vtkSetVector2Macro(InputRange, double);
  vtkGetVector2Macro(InputRange, double);
  ///@}

protected:
  vtkOrderedDither() = default;
  ~vtkOrderedDither() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkOrderedDither(const vtkOrderedDither&) = delete;
  void operator=(const vtkOrderedDither&) = delete;

  bool HasInputRange() const { return this->InputRange[0] != 0.0 || this->InputRange[1] != 0.0; }
  bool CheckParameters(std::string& why) const;

  int NumberOfLevels = 2;
  int Dimensionality = 2;
  int PatternLog2Size = 3;
  int BaseOrder = FCC;
  double InputRange[2] = { 0.0, 0.0 };
};
VTK_ABI_NAMESPACE_END

#endif
