// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TextureSampler
 * @brief   filtered look-up in a rank-1 texture
 *
 * The input is a rank-1 image, or the mip levels or r-set that vtkRank1TexturePyramid makes. A
 * look-up takes a point (u, v), the picture being [0, 1]^2 and repeated beyond, and the footprint
 * of a pixel: du/dx, dv/dx, du/dy, dv/dy. In texel spacings (a spacing being the side of a square
 * of a texel's area, so sqrt(n) of them along a square picture of n texels),
 *
 * - mip levels are chosen by D = log2 L, L being the length of the longer of the two axes
 *   (du/dx, dv/dx) and (du/dy, dv/dy);
 * - members of an r-set by the binary logarithms of the width sqrt((du/dx)^2 + (du/dy)^2) and the
 *   height, likewise.
 *
 * `LevelFilter` NearestLevel takes one level: the nearest to D, the finer of two; of an r-set, by
 * section 5.2 of Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, that of the
 * ratio of width to height nearest to the footprint's, and of these the first whose texel's area is
 * the footprint's or more. Trilinear, the default, blends the two levels on either side of D, or
 * the four members on either side of width and height, and so has no jumps. Footprints smaller than
 * a texel get the base, larger ones than all levels the coarsest.
 *
 * In a level `Interpolation` is Nearest, Bilinear on the fundamental parallelepiped, Barycentric on
 * the Delaunay triangle (default) or BoxSpline, the quartic box-spline of three directions, as in
 * vtkRank1ImageReconstruct and vtkRank1TexturedPolyDataMapper, which draws what this computes.
 *
 * Values are those of the texels, neither scaled nor rounded, in double precision; any scalar type
 * and number of components. Coordinates that are not finite, and footprints that are NaN, give NaN.
 * Look-ups bring the input up to date first. Sample of many points works in parallel.
 *
 * `FileName` in the place of an input names a texture larger than memory that
 * vtkRank1TextureFileWriter has written. Its tiles are read when they are needed and kept in
 * OpenImageIO's cache, `CacheSize` megabytes of them. GetCacheHits and GetCacheMisses count tiles
 * that were there and tiles that had to be read.
 *
 * Errors, and no values: no input, one that is no rank-1 texture, a file that is none or cannot be
 * read, arrays of coordinates or footprints of other numbers of components or tuples.
 *
 * Example:
 * @code
 * sampler = vtkRank1TextureSampler()
 * sampler.SetInputConnection(pyramid.GetOutputPort())
 * sampler.Sample(coordinates, footprints, values)  # arrays of 2 and 4 components, and the result
 * @endcode
 *
 * @sa vtkRank1TexturePyramid vtkRank1TextureFileWriter vtkRank1TexturedPolyDataMapper
 */

#ifndef vtkRank1TextureSampler_h
#define vtkRank1TextureSampler_h

#include "vtkAlgorithm.h"
#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <memory> // For Internals
#include <string> // For names and messages

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;

class VTKBRAVAIS_EXPORT vtkRank1TextureSampler : public vtkAlgorithm
{
public:
  static vtkRank1TextureSampler* New();
  vtkTypeMacro(vtkRank1TextureSampler, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Interpolations
  {
    Nearest,
    Bilinear,
    Barycentric,
    BoxSpline
  };

  enum LevelFilters
  {
    NearestLevel,
    Trilinear
  };

  /**
   * A texture that is not connected to a pipeline.
   */
  void SetInputData(vtkDataObject* texture);

  ///@{
  /**
   * A file of tiles instead of an input. Default "": the input.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Megabytes (2^20 bytes) of tiles that are kept of a file, 10 to 2^20. Default 64. Each thread
   * may have some tiles more in hand.
   */
  vtkSetClampMacro(CacheSize, int, 10, 1048576);
  vtkGetMacro(CacheSize, int);
  ///@}

  ///@{
  /**
   * What is between texels. Default Barycentric.
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
   * Which levels are looked up. Default Trilinear.
   */
  vtkSetClampMacro(LevelFilter, int, NearestLevel, Trilinear);
  vtkGetMacro(LevelFilter, int);
  void SetLevelFilterToNearestLevel() { this->SetLevelFilter(NearestLevel); }
  void SetLevelFilterToTrilinear() { this->SetLevelFilter(Trilinear); }
  const char* GetLevelFilterAsString();
  ///@}

  ///@{
  /**
   * How many levels the texture has, of an r-set along u and along v; components of a texel; and
   * whether it is an r-set. 0 and false where there is no texture.
   */
  int GetNumberOfLevels();
  void GetNumberOfMembers(int columnsAndRows[2]);
  int GetNumberOfComponents();
  bool IsRSet();
  ///@}

  /**
   * D of a footprint, below 0 where the texture is magnified and -infinity for a point; NaN where
   * there is no texture.
   */
  double GetLevel(double dudx, double dvdx, double dudy, double dvdy);

  /**
   * The two logarithms of a footprint's width and height, for members of an r-set.
   */
  void GetMemberLevels(double dudx, double dvdx, double dudy, double dvdy, double levels[2]);

  /**
   * The one level that NearestLevel takes, and of an r-set its member (i, j); -1 for NaN or where
   * there is no texture.
   */
  int GetNearestLevel(double dudx, double dvdx, double dudy, double dvdy);
  void GetNearestMember(double dudx, double dvdx, double dudy, double dvdy, int member[2]);

  /**
   * Looks up one point. The result has as many numbers as texels have components.
   */
  bool Sample(double u, double v, double dudx, double dvdx, double dudy, double dvdy, double* value)
    VTK_SIZEHINT(value, GetNumberOfComponents());

  /**
   * Looks up many points: coordinates of 2 components, or 3 of which the third is not used;
   * footprints of 4 components and as many tuples, or a single tuple for all, or nullptr for
   * points; the result gets the texels' number of components. False after an error.
   */
  bool Sample(vtkDataArray* coordinates, vtkDataArray* footprints, vtkDataArray* values);

  ///@{
  /**
   * Of a file: tiles that were looked for in the cache and found, those that had to be read, bytes
   * that tiles have in memory now, and the most that they had. 0 without a file. ResetStatistics
   * counts hits and misses from 0 again.
   */
  vtkIdType GetCacheHits();
  vtkIdType GetCacheMisses();
  vtkIdType GetCacheMemory();
  vtkIdType GetPeakCacheMemory();
  void ResetStatistics();
  ///@}

protected:
  vtkRank1TextureSampler();
  ~vtkRank1TextureSampler() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkRank1TextureSampler(const vtkRank1TextureSampler&) = delete;
  void operator=(const vtkRank1TextureSampler&) = delete;

  class Internals;
  bool Prepare();
  bool PrepareInput(std::string& why);
  bool CheckFile();
  bool Fail(const std::string& why);

  int Interpolation = Barycentric;
  int LevelFilter = Trilinear;
  std::string FileName;
  int CacheSize = 64;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
