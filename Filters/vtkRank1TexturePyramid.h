// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TexturePyramid
 * @brief   a picture at all resolutions, on rank-1 lattices
 *
 * Rank-1 lattices of maximal minimum distance do not nest, so each level is resampled from the
 * picture itself, as by vtkRank1ImageResample, whose parameters these are (Dammertz, Dammertz,
 * Keller and Lensch, Textures on Rank-1 Lattices, sections 5.2 and 7). The output's blocks are
 * rank-1 images of the input's scalar type:
 *
 * - `Kind` MipLevels (default): block l is level l, S x T tiles of n / 4^l texels, rounded down,
 *   while there is one. All together they have at most 4/3 of the base's texels. A coarser level's
 *   lattice is that of the largest minimum distance for its number of texels.
 * - `Kind` RSet: block j (floor(log2 S) + 1) + i is member (i, j), S / 2^i x T / 2^j tiles, rounded
 *   down, of n texels of the base's generator, until there is one tile each way. All together have
 *   less than four times the base's texels. Members with i not j are anisotropic, finer along u or
 *   along v.
 *
 * Every block holds all of `Rank1.Domain`, and its name is "level 0" ... or "S x T tiles".
 * vtkRank1TextureSampler and vtkRank1TexturedPolyDataMapper take such an output as it is, and one
 * that was written as .vtm and read again.
 *
 * Of a vtkMultiBlockDataSet, or another tree of pictures, the output is a tree of the same shape
 * and names, with a pyramid in each picture's place.
 *
 * Parameters are those of vtkRank1ImageResample; `Generator` is the base's. `Filter` Automatic
 * takes Box for all levels of fewer texels than pixels, and other filters would alias there. A
 * picture of one pixel, or a base of one texel, has one level. Memory is allocated for the output
 * alone.
 *
 * Errors, with an empty output: those of vtkRank1ImageResample, a number of levels below 0, and
 * blocks that are no pictures.
 *
 * Example:
 * @code
 * pyramid = vtkRank1TexturePyramid()
 * pyramid.SetKindToRSet()
 * pyramid.SetTiles(16, 16)
 * pyramid.SetInputConnection(reader.GetOutputPort())
 * pyramid.Update()
 * @endcode
 *
 * @sa vtkRank1ImageResample vtkRank1TextureSampler vtkRank1TexturedPolyDataMapper
 */

#ifndef vtkRank1TexturePyramid_h
#define vtkRank1TexturePyramid_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class VTKBRAVAIS_EXPORT vtkRank1TexturePyramid : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRank1TexturePyramid* New();
  vtkTypeMacro(vtkRank1TexturePyramid, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Kinds
  {
    MipLevels,
    RSet
  };

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
   * Which levels are made. Default MipLevels.
   */
  vtkSetClampMacro(Kind, int, MipLevels, RSet);
  vtkGetMacro(Kind, int);
  void SetKindToMipLevels() { this->SetKind(MipLevels); }
  void SetKindToRSet() { this->SetKind(RSet); }
  const char* GetKindAsString();
  ///@}

  ///@{
  /**
   * How many mip levels at most; 0, the default, for all. An r-set is always complete.
   */
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Texels of each tile of the base; 0, the default, for as many texels in all as the input has
   * pixels.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Tiles of the base along u and v. Default 1, 1.
   */
  vtkSetVector2Macro(Tiles, int);
  vtkGetVector2Macro(Tiles, int);
  ///@}

  ///@{
  /**
   * Generator of the base. Default 0, 0: the lattice of largest minimum distance on a tile's area.
   */
  vtkSetVector2Macro(Generator, vtkIdType);
  vtkGetVector2Macro(Generator, vtkIdType);
  ///@}

  ///@{
  /**
   * Order of the texels, see vtkRank1Lattice. Default Korobov.
   */
  vtkSetClampMacro(Layout, int, Korobov, Locality);
  vtkGetMacro(Layout, int);
  void SetLayoutToKorobov() { this->SetLayout(Korobov); }
  void SetLayoutToLocality() { this->SetLayout(Locality); }
  const char* GetLayoutAsString();
  ///@}

  ///@{
  /**
   * How a texel's value is found, see vtkRank1ImageResample. Default Automatic.
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
   * What is beyond the picture's edge, see vtkRank1ImageResample. Default Periodic.
   */
  vtkSetClampMacro(BoundaryMode, int, Periodic, Mirror);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToPeriodic() { this->SetBoundaryMode(Periodic); }
  void SetBoundaryModeToClamp() { this->SetBoundaryMode(Clamp); }
  void SetBoundaryModeToMirror() { this->SetBoundaryMode(Mirror); }
  const char* GetBoundaryModeAsString();
  ///@}

protected:
  vtkRank1TexturePyramid() = default;
  ~vtkRank1TexturePyramid() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRank1TexturePyramid(const vtkRank1TexturePyramid&) = delete;
  void operator=(const vtkRank1TexturePyramid&) = delete;

  /// Progress runs from begin to end. False with a sentence in `why`, or without where aborted.
  bool MakeLevels(
    vtkImageData* image, vtkMultiBlockDataSet* levels, double begin, double end, std::string& why);

  int Kind = MipLevels;
  int NumberOfLevels = 0;
  vtkIdType NumberOfPoints = 0;
  int Tiles[2] = { 1, 1 };
  vtkIdType Generator[2] = { 0, 0 };
  int Layout = Korobov;
  int Filter = Automatic;
  int BoundaryMode = Periodic;
};
VTK_ABI_NAMESPACE_END

#endif
