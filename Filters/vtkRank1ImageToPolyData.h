// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1ImageToPolyData
 * @brief   cells, triangles or points of a rank-1 image
 *
 * Input: a rank-1 image (vtkRank1ImageResample), any scalar type and number of components. Output,
 * in the picture's plane, by `Shape`:
 *
 * - VoronoiCells: a polygon for each texel, the points nearer to it than to all others, with the
 *   texel's value as cell data.
 * - DelaunayTriangles: triangles whose vertices are texels, two for each, with the values as point
 *   data. Linear interpolation on them is vtkRank1ImageReconstruct's Barycentric.
 * - Points: a vertex for each texel, in the order of the texels, with the values as point data.
 *
 * See Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, section 3. The picture is
 * periodic, so cells and triangles that reach beyond its border are cut there, and the rest is on
 * the other side: together they cover the picture exactly once. Where a triangle is cut there are
 * new points, whose values are interpolated; integers are rounded.
 *
 * Points are in double precision, in the units of the input's domain, turned by its direction
 * matrix. Of numbered pieces each has its share of the texels, and their cells. While it works the
 * filter holds its polygons twice.
 *
 * Errors, with an empty output: an input that is not tagged as a rank-1 image, or whose marks and
 * dimensions contradict each other, and no point scalars.
 *
 * Example:
 * @code
 * cells = vtkRank1ImageToPolyData()
 * cells.SetInputConnection(rank1.GetOutputPort())
 * cells.SetShapeToDelaunayTriangles()
 * @endcode
 *
 * @sa vtkRank1ImageResample vtkRank1Lattice
 */

#ifndef vtkRank1ImageToPolyData_h
#define vtkRank1ImageToPolyData_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkRank1ImageToPolyData : public vtkPolyDataAlgorithm
{
public:
  static vtkRank1ImageToPolyData* New();
  vtkTypeMacro(vtkRank1ImageToPolyData, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    VoronoiCells,
    DelaunayTriangles,
    Points
  };

  ///@{
  /**
   * What the output is made of. Default VoronoiCells.
   */
  vtkSetClampMacro(Shape, int, VoronoiCells, Points);
  vtkGetMacro(Shape, int);
  void SetShapeToVoronoiCells() { this->SetShape(VoronoiCells); }
  void SetShapeToDelaunayTriangles() { this->SetShape(DelaunayTriangles); }
  void SetShapeToPoints() { this->SetShape(Points); }
  const char* GetShapeAsString();
  ///@}

protected:
  vtkRank1ImageToPolyData() = default;
  ~vtkRank1ImageToPolyData() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRank1ImageToPolyData(const vtkRank1ImageToPolyData&) = delete;
  void operator=(const vtkRank1ImageToPolyData&) = delete;

  int Shape = VoronoiCells;
};
VTK_ABI_NAMESPACE_END

#endif
