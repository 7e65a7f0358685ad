// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1ImageResample
 * @brief   a Cartesian picture on a rank-1 lattice
 *
 * Texels are at the points x_i = ({i g1 / n}, {i g2 / n}) of each of S x T tiles of the picture's
 * area, which reaches from edge to edge: W x H pixels of spacing s cover W s.x by H s.y, from
 * origin - s / 2. See Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, sections
 * 3 to 5. The more hexagonal lattice holds more of the picture than as many pixels do.
 *
 * Input: an image of one layer, nx x ny x 1, of any scalar type and number of components. Output: a
 * rank-1 image of dimensions (n, S, T) in the same type, tagged by the field data `Lattice` =
 * Rank1, `Rank1.Generator` (n, g1, g2) and `Rank1.Domain` (xmin, xmax, ymin, ymax). Where the input
 * has a direction matrix, the output has it too, and the domain is along those axes.
 *
 * `Filter` Box is the exact mean over a texel's Voronoi cell, of pixels of constant value; with
 * Periodic boundary the texels' mean is the pixels'. Bilinear, Bicubic (Catmull-Rom) and Nearest
 * take the value at the texel's point. Automatic is Box, and Bilinear where there are more texels
 * than pixels. Arithmetic is in double precision; integers are rounded and clamped, and numbers
 * that are not finite spoil those texels alone that they are a part of.
 *
 * Any piece equals that piece of the whole, and asks for the whole input. Beside its output the
 * filter allocates a row of pixels a thread.
 *
 * Errors, with an empty output: more than one layer, no points or point scalars, a tagged BCC or
 * rank-1 input, a number of points below 0 or beyond 2^30, a generator of fewer points (a divisor
 * common to g1, g2 and n), tiles below 1, a tile's aspect beyond 10^6 : 1, and an output beyond the
 * machine's memory.
 *
 * Example:
 * @code
 * rank1 = vtkRank1ImageResample()
 * rank1.SetNumberOfPoints(65536)
 * rank1.SetInputConnection(reader.GetOutputPort())
 * rank1.Update()
 * @endcode
 *
 * @sa vtkRank1Lattice vtkRank1ImageReconstruct vtkRank1ImageToPolyData
 */

#ifndef vtkRank1ImageResample_h
#define vtkRank1ImageResample_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkRank1ImageResample : public vtkImageAlgorithm
{
public:
  static vtkRank1ImageResample* New();
  vtkTypeMacro(vtkRank1ImageResample, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Filters
  {
    Box,
    Bilinear,
    Bicubic,
    Nearest,
    Automatic
  };

  enum BoundaryModes
  {
    Periodic,
    Clamp,
    Mirror
  };

  enum Layouts
  {
    Korobov,
    Locality
  };

  ///@{
  /**
   * Texels of each tile; 0, the default, for as many texels in all as the input has pixels.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Tiles along u and v. Default 1, 1.
   */
  vtkSetVector2Macro(Tiles, int);
  vtkGetVector2Macro(Tiles, int);
  ///@}

  ///@{
  /**
   * Generator of the lattice. Default 0, 0: the lattice of largest minimum distance on a tile's
   * area.
   */
  vtkSetVector2Macro(Generator, vtkIdType);
  vtkGetVector2Macro(Generator, vtkIdType);
  ///@}

  ///@{
  /**
   * Order of the texels of that lattice, see vtkRank1Lattice. Default Korobov.
   */
  vtkSetClampMacro(Layout, int, Korobov, Locality);
  vtkGetMacro(Layout, int);
  void SetLayoutToKorobov() { this->SetLayout(Korobov); }
  void SetLayoutToLocality() { this->SetLayout(Locality); }
  const char* GetLayoutAsString();
  ///@}

  ///@{
  /**
   * How a texel's value is found. Default Automatic.
   */
  vtkSetClampMacro(Filter, int, Box, Automatic);
  vtkGetMacro(Filter, int);
  void SetFilterToBox() { this->SetFilter(Box); }
  void SetFilterToBilinear() { this->SetFilter(Bilinear); }
  void SetFilterToBicubic() { this->SetFilter(Bicubic); }
  void SetFilterToNearest() { this->SetFilter(Nearest); }
  void SetFilterToAutomatic() { this->SetFilter(Automatic); }
  const char* GetFilterAsString();
  ///@}

  ///@{
  /**
   * What is beyond the picture's edge: the picture again, its border pixels, or its mirror image.
   * Default Periodic.
   */
  vtkSetClampMacro(BoundaryMode, int, Periodic, Mirror);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToPeriodic() { this->SetBoundaryMode(Periodic); }
  void SetBoundaryModeToClamp() { this->SetBoundaryMode(Clamp); }
  void SetBoundaryModeToMirror() { this->SetBoundaryMode(Mirror); }
  const char* GetBoundaryModeAsString();
  ///@}

protected:
  vtkRank1ImageResample() = default;
  ~vtkRank1ImageResample() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRank1ImageResample(const vtkRank1ImageResample&) = delete;
  void operator=(const vtkRank1ImageResample&) = delete;

  vtkIdType NumberOfPoints = 0;
  int Tiles[2] = { 1, 1 };
  vtkIdType Generator[2] = { 0, 0 };
  int Layout = Korobov;
  int Filter = Automatic;
  int BoundaryMode = Periodic;
};
VTK_ABI_NAMESPACE_END

#endif
