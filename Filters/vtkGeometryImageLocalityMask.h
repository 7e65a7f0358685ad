// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryImageLocalityMask
 * @brief   which gixels of a geometry image lie in a volume, by an octree of locality masks
 *
 * An octree over the gixels' positions leaves the image as it is: each node refers to its gixels by
 * a locality mask, a bit a gixel. The nodes are all non-empty cells of depths 0 to D =
 * `MaximumDepth`, and those of depth D are the leaves. The hierarchy is kept until the image or a
 * parameter of it changes; a new volume is a new query only. The output is the input, shared, plus
 * an unsigned char point array `LocalityMask`: 1 where the union of the masks that the volume meets
 * has a bit, else 0. Gixels that are not used (`Defined` 0, or a NaN) are in no mask.
 *
 * Cells: `RootCube` is the lower corner x, y, z and the edge e. An edge of 0, the default, is the
 * smallest cube round the gixels, concentric with their box, its edge times 1 + 1e-6. A point p is
 * in cell floor((p - corner) / e 2^D), half-open; points outside of a cube that was set are in no
 * leaf and in no mask.
 *
 * The volume is the first of these that is set, and the whole space where none is:
 *
 * - `CullFunction`: where a vtkImplicitFunction is negative. vtkPlane, vtkPlanes (a frustum, say),
 *   vtkBox and vtkSphere are tested against cells, from the root down, ending at nodes wholly
 * inside or outside: exactly for vtkPlane, vtkBox and vtkSphere, and for vtkPlanes plane by plane,
 * so that some cells near, but outside, its edges and corners are taken in. With an affine
 *   transform they are tested as the planes and ellipsoids that they then are. Any other function,
 *   or transform, is evaluated at all gixels, and a leaf is met where one of its gixels is inside.
 * - `Camera`, with `AspectRatio`, width over height: its frustum, clipping range included.
 * - a geometry image at input port 1: the leaves of a hierarchy over it, with the same depth and a
 *   cube of its own, so that the mask holds the leaves that overlap one of the other's: the broad
 *   phase of a collision test.
 *
 * No gixel inside the volume is left out. With `RefineToGixels` those outside are: gixels of leaves
 * partly inside are tested themselves.
 *
 * `Encoding` is how the masks are kept: RLE is the paper's run-length code (a run of two or more
 * equal bytes is the byte twice and a 16-bit little-endian count; a lone byte is itself; masks are
 * row-major bits, the least significant first, without row padding), Roaring has Roaring bitmaps'
 * containers of places, runs or bits, and the run-length code for masks which that makes smaller,
 * so that Roaring is never larger. `StoreInternalMasks` keeps masks of inner nodes too, at which a
 * query can end early; without, it goes on to the leaves, and the sizes are those of the leaves.
 *
 * It allocates the mask, and for the hierarchy about 16 bytes a gixel while it is made, a number a
 * gixel and three a node, and the compressed masks. An image piece costs the hierarchy of the
 * whole. Building runs in parallel, and the result does not depend on the number of threads.
 *
 * Errors, with an empty output: an input that is not a geometry image (its tag, an array `Points`
 * of 3 floats or doubles a gixel, a `Defined` of unsigned char, one slice); an infinite coordinate;
 * a MaximumDepth beyond 0 .. 10; a RootCube that is not finite, or of negative edge; a CullFunction
 * with NaN or infinite parameters, a vtkPlanes without planes, a vtkBox whose bounds are not in
 * order; an AspectRatio that is not positive.
 *
 * Example:
 * @code
 * mask = vtkGeometryImageLocalityMask()
 * mask.SetCullFunction(planes)
 * mask.SetInputConnection(source.GetOutputPort())
 * mask.Update()
 * @endcode
 *
 * @sa vtkGeometryImageSource vtkGeometryImageToPolyData
 */

#ifndef vtkGeometryImageLocalityMask_h
#define vtkGeometryImageLocalityMask_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For CullFunction and Camera

#include <memory> // For Internals

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkIdTypeArray;
class vtkImplicitFunction;
class vtkUnsignedCharArray;

class VTKBRAVAIS_EXPORT vtkGeometryImageLocalityMask : public vtkImageAlgorithm
{
public:
  static vtkGeometryImageLocalityMask* New();
  vtkTypeMacro(vtkGeometryImageLocalityMask, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Encodings
  {
    RLE,
    Roaring
  };

  ///@{
  /**
   * Depth of the leaves, 0 to 10. Default 5.
   */
  vtkSetMacro(MaximumDepth, int);
  vtkGetMacro(MaximumDepth, int);
  ///@}

  ///@{
  /**
   * Lower corner x, y, z and edge of the root's cell. Default 0, 0, 0, 0: round the gixels.
   */
  vtkSetVector4Macro(RootCube, double);
  vtkGetVector4Macro(RootCube, double);
  ///@}

  ///@{
  /**
   * How masks are kept. Default RLE.
   */
  vtkSetClampMacro(Encoding, int, RLE, Roaring);
  vtkGetMacro(Encoding, int);
  void SetEncodingToRLE() { this->SetEncoding(RLE); }
  void SetEncodingToRoaring() { this->SetEncoding(Roaring); }
  const char* GetEncodingAsString();
  ///@}

  ///@{
  /**
   * Whether inner nodes have masks too. Default on.
   */
  vtkSetMacro(StoreInternalMasks, bool);
  vtkGetMacro(StoreInternalMasks, bool);
  vtkBooleanMacro(StoreInternalMasks, bool);
  ///@}

  ///@{
  /**
   * Off, the default: the union of the masks of leaves that the volume meets. On: those of its
   * gixels that are inside.
   */
  vtkSetMacro(RefineToGixels, bool);
  vtkGetMacro(RefineToGixels, bool);
  vtkBooleanMacro(RefineToGixels, bool);
  ///@}

  ///@{
  /**
   * The volume as a function that is negative inside. Default none.
   */
  virtual void SetCullFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCullFunction();
  ///@}

  ///@{
  /**
   * A camera whose frustum is the volume, unless there is a CullFunction. Default none.
   */
  virtual void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Width over height of what the camera sees. Default 1.
   */
  vtkSetMacro(AspectRatio, double);
  vtkGetMacro(AspectRatio, double);
  ///@}

  /**
   * Another geometry image, at port 1, whose leaves are the volume unless there is a function or a
   * camera.
   */
  void SetCollisionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /**
   * Of the hierarchy that the last update made or used: the non-empty cells of all depths, those of
   * the last, and the leaves that the volume meets.
   */
  vtkIdType GetNumberOfNodes();
  vtkIdType GetNumberOfLeaves();
  vtkIdType GetNumberOfVisibleLeaves();
  ///@}

  ///@{
  /**
   * Bytes of the masks that are kept, of the leaves alone or of all nodes.
   */
  vtkIdType GetUncompressedSize(bool leavesOnly);
  vtkIdType GetCompressedSize(bool leavesOnly);
  ///@}

  /**
   * Of a Roaring hierarchy, how many masks have the run-length code since that is smaller; else 0.
   */
  vtkIdType GetNumberOfExceptions();

  ///@{
  /**
   * Compressed bytes of the last query's masks: of those that were united, and of their union, the
   * output's mask.
   */
  vtkIdType GetVisibleSize();
  vtkIdType GetUnionSize();
  ///@}

  ///@{
  /**
   * Seconds that the last query took, to find the nodes that the volume meets, and then to unite
   * their masks.
   */
  double GetCullTime();
  double GetUnionTime();
  ///@}

  /**
   * The mask of a leaf, one value a gixel, 0 or 1; leaves are in ascending order of their integer
   * cell (x << 2D) | (y << D) | z. A leaf that there is not is an error: it empties the array and
   * gives false. No array is an error too, here and below.
   */
  bool GetLeafMask(vtkIdType leaf, vtkUnsignedCharArray* mask);

  ///@{
  /**
   * The bytes that are kept of such a leaf's mask, and their code, RLE or Roaring; -1 for a leaf
   * that there is not.
   */
  bool GetLeafCode(vtkIdType leaf, vtkUnsignedCharArray* code);
  int GetLeafEncoding(vtkIdType leaf);
  ///@}

  /**
   * The cells (x, y, z) of the leaves, in that order.
   */
  void GetLeafCells(vtkIdTypeArray* cells);

  ///@{
  /**
   * A line from p1 to p2 and the surface, updating first. The first form finds where the line first
   * meets a triangle, whose gixels it gives, at p1 + t (p2 - p1) = x, and returns whether it
   * does. Four gixels are two triangles, split along the shorter diagonal, and three used ones of
   * four are one. The second fills a mask, as GetLeafMask does, with the leaves whose cells the
   * line passes through, and returns how many there are. A line that is not finite is an error.
   */
  bool IntersectWithLine(
    const double p1[3], const double p2[3], double& t, double x[3], vtkIdType gixels[3]);
  vtkIdType IntersectWithLine(const double p1[3], const double p2[3], vtkUnsignedCharArray* mask);
  ///@}

  /**
   * When the hierarchy was made: it stays the same while that is used again.
   */
  vtkMTimeType GetHierarchyMTime();

  /**
   * The latest time of this object's, the function's and the camera's.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGeometryImageLocalityMask();
  ~vtkGeometryImageLocalityMask() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGeometryImageLocalityMask(const vtkGeometryImageLocalityMask&) = delete;
  void operator=(const vtkGeometryImageLocalityMask&) = delete;

  int MaximumDepth = 5;
  double RootCube[4] = { 0.0, 0.0, 0.0, 0.0 };
  int Encoding = RLE;
  bool StoreInternalMasks = true;
  bool RefineToGixels = false;
  vtkSmartPointer<vtkImplicitFunction> CullFunction;
  vtkSmartPointer<vtkCamera> Camera;
  double AspectRatio = 1.0;

  class Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
