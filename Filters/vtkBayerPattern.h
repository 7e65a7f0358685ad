// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBayerPattern
 * @brief   the recursive order of the cells of a square or a cube
 *
 * A Bayer pattern numbers the cells of a square, or cube, whose side is 2^log2Size, so that the
 * first cells are spread evenly however many are taken: the first 4^j of a square, or 8^j of a
 * cube, are a Cartesian lattice. The numbers (ranks) are the thresholds of ordered dithering, see
 * vtkOrderedDither; the cells in the order of their ranks are the order in which to update an image
 * bit by bit.
 *
 * A pattern of twice the side n is made of copies of the pattern, one a corner e of the base order,
 * that take turns:
 *
 *   rank'(c + n e) = 2^d rank(c) + base(e),  d the dimension.
 *
 * In two dimensions the base order is 00 11 10 01 (xy), which gives the matrices of B. E. Bayer,
 * "An optimum method for two-level rendition of continuous-tone pictures", ICC 1973. In three
 * there is a choice, `BaseOrder`, xyz:
 *
 * - FCC (the default) 000 110 101 011 111 001 010 100. The even corners come first, so the first
 *   2, 3 and 4 cells are as far apart as four can be: a face-centred cubic lattice.
 * - BCC 000 111 110 001 101 010 011 100. Antipodes follow each other, so two cells are a
 *   body-centred cubic lattice, and the pattern has the least power at low frequencies.
 *
 * Arrays hold one number a cell, x fastest; what they held is lost. A dimension other than 2 and 3,
 * a negative size, a size whose ranks or memory cannot be had, and no array are errors: the array
 * is then empty and the result false.
 *
 * Example:
 * @code
 * ranks = vtkIdTypeArray()
 * vtkBayerPattern().GetThresholds(2, 2, ranks)  # 0 8 2 10 12 4 14 6 3 11 1 9 15 7 13 5
 * @endcode
 *
 * @sa vtkOrderedDither
 */

#ifndef vtkBayerPattern_h
#define vtkBayerPattern_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkObject.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDoubleArray;
class vtkIdTypeArray;

class VTKBRAVAIS_EXPORT vtkBayerPattern : public vtkObject
{
public:
  static vtkBayerPattern* New();
  vtkTypeMacro(vtkBayerPattern, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BaseOrders
  {
    FCC,
    BCC
  };

  ///@{
  /**
   * The order of the eight corners of a cube; patterns of two dimensions do not use it. Default
   * FCC.
   */
  vtkSetClampMacro(BaseOrder, int, FCC, BCC);
  vtkGetMacro(BaseOrder, int);
  void SetBaseOrderToFCC() { this->SetBaseOrder(FCC); }
  void SetBaseOrderToBCC() { this->SetBaseOrder(BCC); }
  const char* GetBaseOrderAsString();
  ///@}

  /**
   * The rank of each cell, 0 .. cells - 1.
   */
  bool GetThresholds(int dimension, int log2Size, vtkIdTypeArray* ranks);

  /**
   * Its inverse: the cell at each rank, as x + size (y + size z).
   */
  bool GetOrder(int dimension, int log2Size, vtkIdTypeArray* cells);

  /**
   * For m = 1 .. cells the smallest distance, in cells, between any two of the first m, with the
   * pattern repeated in all directions; of one cell to its own copies, that is the size.
   */
  bool GetMinimumDistances(int dimension, int log2Size, vtkDoubleArray* distances);

  /**
   * Power of what a constant of `count` / cells becomes with two levels, the first `count` cells
   * being 1 and the others 0: |sum of v(c) exp(-2 pi i f.c / size)|^2 / cells, for the frequencies
   * f = 0 .. size - 1 of each axis, the mean subtracted.
   */
  bool GetPowerSpectrum(int dimension, int log2Size, vtkIdType count, vtkDoubleArray* power);

  /**
   * The same of the thresholds (rank + 1/2) / cells themselves.
   */
  bool GetPowerSpectrum(int dimension, int log2Size, vtkDoubleArray* power);

protected:
  vtkBayerPattern() = default;
  ~vtkBayerPattern() override = default;

private:
  vtkBayerPattern(const vtkBayerPattern&) = delete;
  void operator=(const vtkBayerPattern&) = delete;

  template <class Function>
  bool Fill(
    int dimension, int log2Size, vtkDataArray* array, int bytesPerCell, const Function& function);

  int BaseOrder = FCC;
};
VTK_ABI_NAMESPACE_END

#endif
