// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1Lattice
 * @brief   a rank-1 lattice: n points of the unit torus, multiples of one generator
 *
 * The points are x_i = ({i g1 / n}, {i g2 / n}), i = 0 .. n - 1, u to the right and v up (Dammertz,
 * Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, eq. 1). Distances are measured on the
 * `Aspect` area, width x height, whose opposite sides are joined.
 *
 * The basis (b1, b2) is Minkowski-reduced, |b1| <= |b2| <= |b2 - b1|, in whole units of the n x n
 * grid, whose cells are width / n by height / n. Point s b1 + t b2 has index (s k + t l) mod n,
 * where k and l are the basis' indices (Theorem 2).
 *
 * MaximizeMinimumDistance sets the generator to the best that there is: exact over all rank-1
 * lattices of n points, in Korobov form (1, a) where equals allow it, in milliseconds up to 2^24
 * points. `Layout` chooses among the generators of that lattice, which differ in the order of
 * points alone: Korobov, the order of u, or Locality, where the next index is a neighbour. By the
 * measure of GetLayoutMeasure the latter has about 2/3, the former mostly 1.
 *
 * A number of points that is not 1 to 2^31 - 1, numbers g1, g2 and n with a common divisor (these
 * generate fewer points), and an aspect that is not positive and finite, or beyond 10^6 : 1, are an
 * error of every question asked; answers are then 0, or -1 for an index.
 *
 * Example:
 * @code
 * lattice = vtkRank1Lattice()
 * lattice.SetNumberOfPoints(262144)
 * lattice.MaximizeMinimumDistance()  # generator (1, 1990), efficiency 0.903
 * @endcode
 *
 * @sa vtkRank1ImageResample
 */

#ifndef vtkRank1Lattice_h
#define vtkRank1Lattice_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkRank1Lattice : public vtkObject
{
public:
  static vtkRank1Lattice* New();
  vtkTypeMacro(vtkRank1Lattice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Korobov: (1, a) or, where there is none, the least g1, then g2. Locality: the shortest vector
   * that generates the lattice, so that texels of consecutive indices are neighbours.
   */
  enum Layouts
  {
    Korobov,
    Locality
  };

  ///@{
  /**
   * How many points, 1 to 2^31 - 1. Default 1.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Generator, modulo the number of points. Default (1, 1).
   */
  vtkSetVector2Macro(Generator, vtkIdType);
  vtkGetVector2Macro(Generator, vtkIdType);
  ///@}

  ///@{
  /**
   * Width and height of the area that distances are measured on. Default 1, 1.
   */
  vtkSetVector2Macro(Aspect, double);
  vtkGetVector2Macro(Aspect, double);
  ///@}

  ///@{
  /**
   * Which generator of the best lattice MaximizeMinimumDistance chooses. Default Korobov.
   */
  vtkSetClampMacro(Layout, int, Korobov, Locality);
  vtkGetMacro(Layout, int);
  void SetLayoutToKorobov() { this->SetLayout(Korobov); }
  void SetLayoutToLocality() { this->SetLayout(Locality); }
  const char* GetLayoutAsString();
  ///@}

  /**
   * Sets the generator to that of a lattice whose minimum distance is the largest of all rank-1
   * lattices with so many points on this aspect. False, and nothing is changed, after an error.
   */
  bool MaximizeMinimumDistance();

  ///@{
  /**
   * The reduced basis, in units of the n x n grid.
   */
  void GetBasis(vtkIdType b1[2], vtkIdType b2[2]);
  void GetBasis(double b1[2], double b2[2]);
  ///@}

  /**
   * Indices k and l of the basis.
   */
  void GetBasisIndices(vtkIdType kl[2]);

  /**
   * Basis of the dual lattice, in units of 1 / aspect: its products with b1 and b2 are 1 and 0.
   */
  void GetDualBasis(double d1[2], double d2[2]);

  /**
   * The six corners of the Voronoi cell of point 0, counter-clockwise, each u, v on the unit torus.
   */
  void GetVoronoiCell(double corners[12]);

  /**
   * Distance of the nearest two points, in the units of the aspect; a point's own copies count.
   */
  double GetMinimumDistance();

  /**
   * The share of a Voronoi cell that its in-circle covers, pi d^2 / (4 area): 0.785 for squares,
   * and 0.907 for regular hexagons, the most that there is.
   */
  double GetSamplingEfficiency();

  /**
   * The share of steps to one of the six neighbours that leave a line of so many texels: the mean
   * of min(1, d / line) over their distances d in memory, modulo n.
   */
  double GetLayoutMeasure(int line);

  /**
   * Position of point i, modulo n, on the unit torus.
   */
  void GetPoint(vtkIdType i, double uv[2]);

  /**
   * Index of the point s b1 + t b2.
   */
  vtkIdType GetIndex(vtkIdType s, vtkIdType t);

  /**
   * Index of the point nearest to (u, v) on the torus. Coordinates that are not finite are an
   * error.
   */
  vtkIdType FindNearest(double u, double v);

  /**
   * Indices of the points at b1, b2, b2 - b1, -b1, -b2 and b1 - b2 from point i.
   */
  void GetNeighbors(vtkIdType i, vtkIdType ids[6]);

protected:
  vtkRank1Lattice();
  ~vtkRank1Lattice() override;

private:
  vtkRank1Lattice(const vtkRank1Lattice&) = delete;
  void operator=(const vtkRank1Lattice&) = delete;

  class Internals;
  bool Prepare();

  vtkIdType NumberOfPoints = 1;
  vtkIdType Generator[2] = { 1, 1 };
  double Aspect[2] = { 1.0, 1.0 };
  int Layout = Korobov;
  std::unique_ptr<Internals> Cache;
};
VTK_ABI_NAMESPACE_END

#endif
