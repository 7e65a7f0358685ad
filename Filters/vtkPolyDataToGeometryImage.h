// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataToGeometryImage
 * @brief   samples a triangle mesh on a regular grid, by a parametrisation of low stretch
 *
 * The mesh is spread over a rectangle without turning any triangle over, and the point of the
 * surface at each of width x height places of it is a gixel of the output, see
 * vtkGeometryImageSource. The mesh is a disk or a closed surface of genus 0.
 *
 * A disk's boundary becomes the rectangle's. Its corners are at the four sharpest turns, or a
 * quarter of the length apart where there are none, and the sides are divided by length.
 *
 * A closed surface is spread over the rectangle with each edge folded on itself about its middle,
 * as that of octahedral layouts: a pillow, flat but for these four middles. Four vertices far apart
 * on the surface are there, and nothing else is fixed, so no cut is seen in the sampling. Gixels
 * (i, 0) and (width - 1 - i, 0) are equal to the last bit, and so are those of the other edges, and
 * all four corners: the surface closes. With odd dimensions the folds are gixels.
 *
 * Vertices are at positively weighted means of their neighbours, which is an embedding of a disk
 * (M. S. Floater, CAGD 1997) and of a pillow (N. Aigerman, Y. Lipman, "Orbifold Tutte embeddings",
 * SIGGRAPH Asia 2015). Weights are first those of a conformal map, then divided by the stretch
 * where it is high (S. Yoshizawa, A. Belyaev, H.-P. Seidel, SMI 2004). For closed surfaces this is
 * done for each order of the four vertices that a tree of shortest ways suggests, and the best is
 * kept. Then the L2 stretch (P. V. Sander, J. Snyder, S. J. Gortler, H. Hoppe, SIGGRAPH 2001), and
 * a tenth of the inverse map's, are lessened by descent of all vertices, and of each in turn, in
 * rounds, at most `Rounds` of them, until a round removes less than a hundredth.
 *
 * Input: polygons and triangle strips, which are triangulated; vertices and lines are left out.
 * Points at the same place to the last bit are one, the first; triangles with a corner twice, and
 * those that have the same three corners as an earlier one, are dropped. Triangles need not have
 * one sense: the sense of most is the image's. Triangles without area are kept. Edges inside a disk
 * that join two points of one side are split in the middle.
 *
 * Output: `Points` (float, or double where the mesh's points are), set as vectors, and the mesh's
 * point arrays, interpolated in the same triangles; normals are scaled to length 1, and cell arrays
 * left out. Spacing is 1. A piece of the extent equals that piece of the whole, and the
 * parametrisation is kept until mesh, dimensions or rounds change. It runs in one thread.
 *
 * Memory: about a kilobyte a vertex while it runs, mostly for sparse matrices.
 *
 * Errors, with an empty output: dimensions below 2 x 2, or too large for memory; a mesh without
 * triangles, or with coordinates that are not finite; edges with more than two triangles; vertices
 * at which parts meet at a point; a one-sided mesh; more than one component; a genus above 0 or
 * more than one boundary (the error tells both numbers); and parts so long and thin that double
 * precision cannot tell their triangles apart.
 *
 * Example:
 * @code
 * image = vtkPolyDataToGeometryImage()
 * image.SetDimensions(257, 257)
 * image.SetInputConnection(reader.GetOutputPort())
 * image.Update()
 * @endcode
 *
 * @sa vtkGeometryImageToPolyData vtkGeometryImageSource vtkGeometryImageLocalityMask
 */

#ifndef vtkPolyDataToGeometryImage_h
#define vtkPolyDataToGeometryImage_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For Internals
#include <string> // For the checks' messages

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKBRAVAIS_EXPORT vtkPolyDataToGeometryImage : public vtkImageAlgorithm
{
public:
  static vtkPolyDataToGeometryImage* New();
  vtkTypeMacro(vtkPolyDataToGeometryImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Width and height of the image, at least 2. Stretch is that of their rectangle, and 2^k + 1 is
   * best for levels of detail. Default 257, 257.
   */
  vtkSetVector2Macro(Dimensions, int);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The most rounds of descent that lessen the stretch, 0 to 1000. Default 8.
   */
  vtkSetClampMacro(Rounds, int, 0, 1000);
  vtkGetMacro(Rounds, int);
  ///@}

  /**
   * Of the last parametrisation: the root mean square of the stretch over the surface, 1 for a map
   * that keeps shapes and areas; and how many triangles are turned over or flat, which is 0.
   */
  double GetStretch() { return this->Stretch; }
  int GetNumberOfFlippedTriangles() { return this->NumberOfFlippedTriangles; }

protected:
  vtkPolyDataToGeometryImage();
  ~vtkPolyDataToGeometryImage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataToGeometryImage(const vtkPolyDataToGeometryImage&) = delete;
  void operator=(const vtkPolyDataToGeometryImage&) = delete;

  bool CheckDimensions(std::string& why);
  bool Parametrize(vtkPolyData* mesh, std::string& why);

  int Dimensions[2] = { 257, 257 };
  int Rounds = 8;
  double Stretch = 0.0;
  int NumberOfFlippedTriangles = 0;

  struct Internals;
  std::unique_ptr<Internals> Members;
};
VTK_ABI_NAMESPACE_END

#endif
