// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCLattice
 * @brief   what is common to all images on the body-centred cubic lattice
 *
 * A BCC volume is a vtkImageData whose field data hold a vtkStringArray named `Lattice` with the
 * one value `BCC`. Index (i, j, k), k a z-layer, is the point of lattice coordinates
 *
 *   X = 2 i + (k & 1),  Y = 2 j + (k & 1),  Z = k
 *
 * (all even or all odd), and of world position, with origin o and spacing s,
 *
 *   x = o.x + s.x (i + (k & 1) / 2),  y = o.y + s.y (j + (k & 1) / 2),  z = o.z + s.z k.
 *
 * k is the index in the whole extent, so that a piece that starts at an odd layer is still right.
 * The lattice is isotropic when s.x = s.y = 2 s.z. Positions follow the image's direction matrix.
 *
 * Example:
 * @code
 * vtkBCCLattice.Tag(image)
 * x = [0.0, 0.0, 0.0]
 * vtkBCCLattice.GetPoint(image, (0, 0, 1), x)  # half a spacing along x and y
 * @endcode
 *
 * Helpers that are given no image report an error and change nothing.
 */

#ifndef vtkBCCLattice_h
#define vtkBCCLattice_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkObject.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;

class VTKBRAVAIS_EXPORT vtkBCCLattice : public vtkObject
{
public:
  static vtkBCCLattice* New();
  vtkTypeMacro(vtkBCCLattice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The kernels, by their number of directions: linear box-spline of 4 directions, quartic of
   * 4 + 3, quintic of 4 taken twice, and the tri-cubic B-spline on both cosets.
   */
  enum Kernels
  {
    BCC4 = 4,
    BCC7 = 7,
    BCC8 = 8,
    BCC12 = 12
  };

  /**
   * Marks an image as a BCC volume.
   */
  static void Tag(vtkImageData* image);

  /**
   * Whether a data object is an image that is marked as a BCC volume; false for nullptr.
   */
  static bool IsBCC(vtkDataObject* data);

  /**
   * World position of the point of index ijk.
   */
  static void GetPoint(vtkImageData* image, const int ijk[3], double x[3]);

  /**
   * The volume's box (xmin, xmax, ymin, ymax, zmin, zmax) in the world: along x from the first
   * point of the even layers to the last of the odd ones, n - 1/2 spacings for n points, along y
   * likewise, and along z from the first layer to the last. vtkImageData's own bounds are half a
   * spacing short. An empty image has the bounds of vtkMath::UninitializeBounds. Of a marked piece
   * (MarkPiece) it is the part that is the piece's own.
   */
  static void GetBox(vtkImageData* image, double bounds[6]);

  ///@{
  /**
   * Marks an image as a piece of a volume of the whole extent, with ghosts: of what the image
   * holds, the box of the extent `piece` is its own. As pieces of VTK's pipeline do, neighbours
   * share a layer of points, the last of the one, which is the first of the other; what is on it
   * belongs to the latter. Along z the box goes from the first layer to the last, along x from the
   * even points of the first index to those of the last, or to the odd ones where the whole ends.
   * An empty `piece` owns nothing. The marks are integer arrays in the field data,
   * BCC.WholeExtent and BCC.PieceExtent. GetPiece returns whether there are such.
   */
  static void MarkPiece(vtkImageData* image, const int whole[6], const int piece[6]);
  static bool GetPiece(vtkImageData* image, int whole[6], int piece[6]);
  ///@}

  ///@{
  /**
   * Notes the range that a component of an array of that name has in the whole volume, of which a
   * piece may have less: colours are looked up over it. An array of ranges, BCC.WholeRange.<name>,
   * in the field data. GetWholeRange returns whether there is such.
   */
  static void MarkWholeRange(
    vtkImageData* image, const char* name, int component, const double range[2]);
  static bool GetWholeRange(vtkImageData* image, const char* name, int component, double range[2]);
  ///@}

  /**
   * The kernel (BCC4, BCC7, BCC8 or BCC12) centred at 0, at a point in lattice coordinates, scaled
   * so that its shifts to all lattice points sum to 1: an even function, zero from 4 on along any
   * axis. A kernel that there is not, or a coordinate that is not finite, is an error, and gives 0.
   */
  static double Evaluate(int kernel, double x, double y, double z);

protected:
  vtkBCCLattice() = default;
  ~vtkBCCLattice() override = default;

private:
  vtkBCCLattice(const vtkBCCLattice&) = delete;
  void operator=(const vtkBCCLattice&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
