// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BSplineSampler_h
#define BSplineSampler_h

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace bravais
{

/// How coefficients 0 .. count - 1 are continued.
enum class BSplineBorder
{
  Clamp,
  Repeat,
  Mirror ///< about the first and the last
};

/// A uniform B-spline's weights at equidistant positions along one axis.
class BSplineAxis
{
public:
  /// For the positions start + step n, n = first .. last, among so many coefficients.
  BSplineAxis(
    int degree, BSplineBorder border, int count, double start, double step, int first, int last);

  int GetNumberOfTaps() const { return this->Taps; }
  int GetNumberOfPositions() const { return static_cast<int>(this->Weights.size()) / this->Taps; }

  /// The degree + 1 coefficients' indices, and their weights, at the n-th position from 0.
  const int* GetIndices(int n) const
  {
    return this->Indices.data() + std::int64_t{ n } * this->Taps;
  }
  const double* GetWeights(int n) const
  {
    return this->Weights.data() + std::int64_t{ n } * this->Taps;
  }

  /// The least and the largest of all indices.
  int GetFirstIndex() const;
  int GetLastIndex() const;

private:
  int Taps;
  std::vector<int> Indices;
  std::vector<double> Weights;
};

/// Evaluates a tensor-product B-spline of coefficients on a Cartesian grid, T float or double, on
/// the grid of three axes' positions, layer by layer and in double precision.
///
/// Layers of coefficients that have been interpolated along x and y are kept for the next layer, so
/// ascending order saves work; the results do not depend on it. Each thread needs its own sampler.
template <class T>
class BSplineSampler
{
public:
  /// The axes have to outlive the sampler. Coefficients are x fastest, `stride` numbers a point, of
  /// which the first `components` are used.
  BSplineSampler(const T* coefficients, const glm::ivec3& dimensions, int stride, int components,
    const std::array<const BSplineAxis*, 3>& axes);

  /// The values of the k-th layer, x fastest, components interleaved; valid until the next call.
  const std::vector<double>& Evaluate(int k);

private:
  struct Slice
  {
    int Layer = -1; // of the coefficients
    std::vector<double> Values;
  };

  const Slice* GetSlice(int layer, const int* needed);
  void Fill(Slice& slice, int layer);

  const T* Coefficients;
  glm::ivec3 Dimensions;
  int Stride;
  int Components;
  std::array<const BSplineAxis*, 3> Axes;
  std::vector<Slice> Slices;  // as many as taps along z
  std::vector<double> Rows;   // a layer of coefficients, interpolated along x
  std::vector<double> Values; // the result
};

} // namespace bravais

#endif
