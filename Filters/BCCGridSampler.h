// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCGridSampler_h
#define BCCGridSampler_h

#include "BCCBlock.h"
#include "BCCKernel.h"
#include "vtkBravaisABINamespace.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
VTK_ABI_NAMESPACE_END

namespace bravais
{

template <class R>
class BCCCoefficientWindow;
template <class R>
struct BCCResults;

/// Evaluates a BCC spline at a piece of a Cartesian grid that spans the volume's box: the loops of
/// vtkBCCVolumeToImage.
///
/// The work goes along z in slabs. A slab's layers of coefficients are made from the samples and
/// continued by the mirrors, in parallel; then its rows of points are evaluated, in parallel. The
/// layers that the next slab needs too are kept. Slabs are as thick as a tenth of input and output
/// allows, so the whole volume's coefficients are never held.
class BCCGridSampler
{
public:
  /// `whole` is the volume's extent, `dimensions` the number of points from face to face (one lies
  /// in the middle), `piece` those to evaluate, not empty.
  BCCGridSampler(const BCCExtent& whole, const int dimensions[3], const BCCExtent& piece);

  void SetKernel(BCCKernel kernel) { this->Kernel = kernel; }

  /// Whether the source's samples are quasi-interpolated; else they are the coefficients.
  void SetQuasiInterpolation(bool on) { this->QuasiInterpolation = on; }

  /// The samples that the piece needs.
  BCCExtent GetInputExtent() const;

  /// What turns derivatives along the lattice coordinates into those that are put out.
  void SetGradientMatrix(int row, int column, double v) { this->GradientMatrix[row][column] = v; }

  /// Whether places inside a few layers can be counted in 31 bits, as the vectors do.
  bool IsLayerSmallEnough() const;

  /// Fills `values` (any type, the source's components) and, unless it is nullptr, `gradients`
  /// (float or double, three times the components). The source holds `held`. Progress runs from
  /// `begin` to 1; false if it was aborted.
  bool Execute(vtkAlgorithm* self, vtkDataArray* source, const BCCExtent& held,
    vtkDataArray* values, vtkDataArray* gradients, double begin) const;

private:
  /// The types of source and values are behind these two: makes one layer of coefficients, and puts
  /// a row of results of one component at its place, that of point `first` on.
  template <class R>
  using FillFunction = std::function<void(int k, const std::vector<BCCBlock<R>>& planes)>;
  template <class R>
  using StoreFunction = std::function<void(const R* results, std::size_t first, int component)>;

  template <class R>
  bool Run(vtkAlgorithm* self, BCCCoefficientWindow<R>& window, const FillFunction<R>& fill,
    const StoreFunction<R>& store, vtkDataArray* gradients, double begin) const;

  template <class R>
  void StoreGradients(const BCCResults<R>& row, std::size_t size, R* target, int stride) const;

  double GetPosition(int axis, int n) const;
  int GetFloor(int axis, int n) const;
  BCCExtent GetPaddedExtent() const;

  BCCExtent Whole;
  int Dimensions[3];
  BCCExtent Piece;
  BCCKernel Kernel = BCCKernel::BCC7;
  bool QuasiInterpolation = true;
  double GradientMatrix[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
};

} // namespace bravais

#endif
