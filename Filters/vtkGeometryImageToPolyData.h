// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryImageToPolyData
 * @brief   triangles of a geometry image
 *
 * Each gixel is a vertex, and each square of four gixels two triangles, split along the shorter of
 * its diagonals (along the one from the lower left where they are equally long). See Gu, Gortler
 * and Hoppe, Geometry Images, SIGGRAPH 2002. Triangles are oriented so that a normal is the
 * derivative along columns times that along rows.
 *
 * `LevelOfDetail` l takes every 2^l-th gixel along both directions, and the last of a row and the
 * last row in any case: the border of a chart stays where it is, and nothing is cut off an image
 * whose dimensions are not 2^l k + 1. Of those dimensions, edges that meet (a closed surface) meet
 * at level l too.
 *
 * Charts: a gixel whose `Defined` is 0, or that has a coordinate which is not a number, is unused.
 * Only triangles that cover used gixels alone are made, at any level, so that no triangle bridges
 * the gap between two charts. A square with three used corners is one triangle.
 *
 * Masks: with `UseLocalityMask` and a point array `LocalityMask` of one component, only triangles
 * with a masked vertex are made. At level l a vertex is masked if any gixel is that lies nearer to
 * it than its neighbours of the level do, along both directions; so the triangles cover what the
 * masked gixels' own triangles cover.
 *
 * Output: polygons of three points each, or triangle strips, row by row. Its points are the level's
 * used gixels, whatever the mask, row by row, with the image's point arrays but for `Points` and
 * `Defined`. Where all gixels are used and l is 0, points and arrays are the image's own, not
 * copies. `Normals` (float) are central differences on the grid of the image itself, at any level;
 * they go on beyond edges that are folded or joined, as those of closed octahedral layouts and
 * tori. `TextureCoordinates` (float) run from 0 to 1 along columns and rows; they are made unless
 * the image has texture coordinates.
 *
 * Where a numbered piece is asked for, it has that part of the rows of squares. Memory: a byte a
 * gixel, and the output's arrays; connectivity is in 32 bits where that is enough.
 *
 * Errors, with an empty output: an image that is not a geometry image, or has no 3-component
 * float or double array `Points`; infinite coordinates; a `LocalityMask` that is not one unsigned
 * char a gixel; a level of detail below 0 or above 30. An image of one row or column, or whose
 * gixels are all unused, has no triangles, which is no error.
 *
 * Example:
 * @code
 * surface = vtkGeometryImageToPolyData()
 * surface.SetLevelOfDetail(1)
 * surface.SetInputConnection(mask.GetOutputPort())
 * mapper.SetInputConnection(surface.GetOutputPort())
 * @endcode
 *
 * @sa vtkPolyDataToGeometryImage vtkGeometryImageLocalityMask
 */

#ifndef vtkGeometryImageToPolyData_h
#define vtkGeometryImageToPolyData_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the checks' messages

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class VTKBRAVAIS_EXPORT vtkGeometryImageToPolyData : public vtkPolyDataAlgorithm
{
public:
  static vtkGeometryImageToPolyData* New();
  vtkTypeMacro(vtkGeometryImageToPolyData, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Every 2^LevelOfDetail-th gixel is taken, 0 to 30. Default 0: all.
   */
  vtkSetMacro(LevelOfDetail, int);
  vtkGetMacro(LevelOfDetail, int);
  ///@}

  ///@{
  /**
   * Whether the array LocalityMask, where the image has one, chooses triangles. Default on.
   */
  vtkSetMacro(UseLocalityMask, bool);
  vtkGetMacro(UseLocalityMask, bool);
  vtkBooleanMacro(UseLocalityMask, bool);
  ///@}

  ///@{
  /**
   * Whether triangles are joined to strips, which need less memory. Default off.
   */
  vtkSetMacro(GenerateTriangleStrips, bool);
  vtkGetMacro(GenerateTriangleStrips, bool);
  vtkBooleanMacro(GenerateTriangleStrips, bool);
  ///@}

  ///@{
  /**
   * Whether normals are made, in place of any the image has. Default on.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * Whether texture coordinates are made where the image has none. Default on.
   */
  vtkSetMacro(ComputeTextureCoordinates, bool);
  vtkGetMacro(ComputeTextureCoordinates, bool);
  vtkBooleanMacro(ComputeTextureCoordinates, bool);
  ///@}

protected:
  vtkGeometryImageToPolyData() = default;
  ~vtkGeometryImageToPolyData() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkGeometryImageToPolyData(const vtkGeometryImageToPolyData&) = delete;
  void operator=(const vtkGeometryImageToPolyData&) = delete;

  vtkDataArray* FindMask(vtkImageData* image);
  bool CheckInput(vtkImageData* image, std::string& why);

  int LevelOfDetail = 0;
  bool UseLocalityMask = true;
  bool GenerateTriangleStrips = false;
  bool ComputeNormals = true;
  bool ComputeTextureCoordinates = true;
};
VTK_ABI_NAMESPACE_END

#endif
