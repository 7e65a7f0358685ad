// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCGridSampler.h"

#include "BCCCoefficientWindow.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSplineRows.h"
#include "RoundTo.h"
#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bravais
{

namespace
{

int HalfFloor(int n)
{
  return (n - (n & 1)) / 2;
}

/// One thread's results for a row of points.
template <class R>
struct RowBuffers
{
  explicit RowBuffers(std::size_t size, bool gradient)
    : Numbers((gradient ? 4 : 1) * GetBCCResultSize(size))
  {
    const std::size_t length = GetBCCResultSize(size);
    this->Results.Value = this->Numbers.data();
    if (gradient)
    {
      this->Results.X = this->Numbers.data() + length;
      this->Results.Y = this->Numbers.data() + 2 * length;
      this->Results.Z = this->Numbers.data() + 3 * length;
    }
  }
  std::vector<R> Numbers;
  BCCResults<R> Results;
};

/// Puts rows of `width` results into an array of any type.
template <class R, class O>
std::function<void(const R*, std::size_t, int)> MakeStore(
  O* values, std::size_t width, int components)
{
  return [=](const R* results, std::size_t first, int component)
  {
    O* target = values + first * static_cast<std::size_t>(components) + component;
    for (std::size_t n = 0; n < width; ++n, target += components)
    {
      *target = RoundTo<O>(results[n]);
    }
  };
}

} // namespace

//------------------------------------------------------------------------------
BCCGridSampler::BCCGridSampler(
  const BCCExtent& whole, const int dimensions[3], const BCCExtent& piece)
  : Whole(whole)
  , Dimensions{ dimensions[0], dimensions[1], dimensions[2] }
  , Piece(piece)
{
}

//------------------------------------------------------------------------------
double BCCGridSampler::GetPosition(int axis, int n) const
{
  const double first = this->Whole[2 * axis] * (axis < 2 ? 2.0 : 1.0);
  const double count = static_cast<double>(this->Whole[2 * axis + 1]) - this->Whole[2 * axis];
  const double length = axis < 2 ? 2.0 * count + 1.0 : count;
  const int steps = this->Dimensions[axis] - 1;
  // The product comes first: then the last point lies on the face to the last bit.
  return first + (steps == 0 ? 0.5 * length : n * length / steps);
}

//------------------------------------------------------------------------------
int BCCGridSampler::GetFloor(int axis, int n) const
{
  return static_cast<int>(std::floor(this->GetPosition(axis, n)));
}

//------------------------------------------------------------------------------
BCCExtent BCCGridSampler::GetPaddedExtent() const
{
  BCCExtent padded;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = this->GetFloor(axis, this->Piece[2 * axis]);
    const int high = this->GetFloor(axis, this->Piece[2 * axis + 1]);
    padded[2 * axis] = (axis < 2 ? HalfFloor(low) : low) - BCCReachBelow[axis];
    padded[2 * axis + 1] = (axis < 2 ? HalfFloor(high) : high) + BCCReachAbove[axis];
  }
  return padded;
}

//------------------------------------------------------------------------------
BCCExtent BCCGridSampler::GetInputExtent() const
{
  BCCExtent needed = this->GetPaddedExtent();
  // What lies beyond the box is the mirror image of what lies as far inside, which the other side
  // of the stencil needs anyway; but for one layer, as they are read from 3 below to 4 above.
  needed[4] = std::min(needed[4], 2 * this->Whole[5] - needed[5]);
  const int margin = this->QuasiInterpolation ? 1 : 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    needed[2 * axis] = std::max(needed[2 * axis] - margin, this->Whole[2 * axis]);
    needed[2 * axis + 1] = std::min(needed[2 * axis + 1] + margin, this->Whole[2 * axis + 1]);
  }
  return needed;
}

//------------------------------------------------------------------------------
bool BCCGridSampler::IsLayerSmallEnough() const
{
  const BCCExtent e = this->GetPaddedExtent();
  return (static_cast<double>(e[1]) - e[0] + 1.0) * (static_cast<double>(e[3]) - e[2] + 1.0) <
    (1 << 28);
}

//------------------------------------------------------------------------------
template <class R>
bool BCCGridSampler::Run(vtkAlgorithm* self, BCCCoefficientWindow<R>& window,
  const FillFunction<R>& fill, const StoreFunction<R>& store, vtkDataArray* gradients,
  double begin) const
{
  const int components = static_cast<int>(window.GetPlanes().size());
  const BCCExtent& e = this->Piece;
  const std::size_t width = static_cast<std::size_t>(e[1] - e[0] + 1);
  const int height = e[3] - e[2] + 1;
  BCCPositions<R> x(width);
  x.SetDense(this->Dimensions[0] > 1.25 * (this->Whole[1] - this->Whole[0] + 1.0));
  for (int i = e[0]; i <= e[1]; ++i)
  {
    x.Set(static_cast<std::size_t>(i - e[0]), BCCPosition<R>(this->GetPosition(0, i)));
  }
  R* slopes = gradients ? static_cast<R*>(gradients->GetVoidPointer(0)) : nullptr;
  const auto evaluate = [&](int z, int j, const BCCResults<R>& row)
  {
    const BCCPosition<R> py(this->GetPosition(1, j));
    const BCCPosition<R> pz(this->GetPosition(2, z));
    const std::size_t first = width *
      (static_cast<std::size_t>(j - e[2]) +
        static_cast<std::size_t>(height) * static_cast<std::size_t>(z - e[4]));
    for (int c = 0; c < components; ++c)
    {
      EvaluateBCCRow<R>(this->Kernel, window.GetPlane(c), x, py, pz, row);
      store(row.Value, first, c);
      if (slopes)
      {
        R* target =
          slopes + 3 * (first * static_cast<std::size_t>(components) + static_cast<std::size_t>(c));
        this->StoreGradients(row, width, target, 3 * components);
      }
    }
  };

  // Parts of slices: enough of them for all threads, however few slices a slab has.
  const int rows = std::min(height, 16);
  const int parts = (height + rows - 1) / rows;
  const double slices = e[5] - e[4] + 1;
  for (int z = e[4]; z <= e[5];)
  {
    const int low = this->GetFloor(2, z) - BCCReachBelow.z;
    int last = z;
    while (
      last < e[5] && this->GetFloor(2, last + 1) + BCCReachAbove.z - low < window.GetCapacity())
    {
      ++last;
    }
    window.MoveTo(low, this->GetFloor(2, last) + BCCReachAbove.z);
    const auto layer = [&](int k) { fill(k, window.GetPlanes()); };
    const auto part = [&](int n)
    {
      RowBuffers<R> buffers(width, slopes != nullptr);
      const int start = e[2] + rows * (n % parts);
      for (int j = start; j < std::min(start + rows, e[3] + 1); ++j)
      {
        evaluate(z + n / parts, j, buffers.Results);
      }
    };
    const double from = begin + (1.0 - begin) * (z - e[4]) / slices;
    const double to = begin + (1.0 - begin) * (last + 1 - e[4]) / slices;
    const double filled = from + 0.1 * (to - from);
    if (!ForEachSlice(self, window.GetFirstMissing(), window.GetLast(), layer, from, filled) ||
      !ForEachSlice(self, 0, (last - z + 1) * parts - 1, part, filled, to))
    {
      return false;
    }
    z = last + 1;
  }
  return true;
}

//------------------------------------------------------------------------------
template <class R>
void BCCGridSampler::StoreGradients(
  const BCCResults<R>& row, std::size_t size, R* target, int stride) const
{
  R m[3][3];
  for (int n = 0; n < 9; ++n)
  {
    m[n / 3][n % 3] = static_cast<R>(this->GradientMatrix[n / 3][n % 3]);
  }
  for (std::size_t n = 0; n < size; ++n, target += stride)
  {
    const R g[3] = { row.X[n], row.Y[n], row.Z[n] };
    for (int axis = 0; axis < 3; ++axis)
    {
      target[axis] = m[axis][0] * g[0] + m[axis][1] * g[1] + m[axis][2] * g[2];
    }
  }
}

//------------------------------------------------------------------------------
bool BCCGridSampler::Execute(vtkAlgorithm* self, vtkDataArray* source, const BCCExtent& held,
  vtkDataArray* values, vtkDataArray* gradients, double begin) const
{
  const int components = source->GetNumberOfComponents();
  const std::size_t width = static_cast<std::size_t>(this->Piece[1] - this->Piece[0] + 1);
  const auto bytes = [](vtkDataArray* array)
  { return array ? static_cast<double>(array->GetDataSize()) * array->GetDataTypeSize() : 0.0; };
  // Less than a tenth: rows of results, and layers between samples and planes, come on top.
  const double room = 0.09 * (bytes(source) + bytes(values) + bytes(gradients));
  bool done = false;
  const auto run = [&](auto sample)
  {
    using T = decltype(sample);
    using R = BCCCoefficient<T>;
    const BCCBlock<const T> samples(
      static_cast<const T*>(source->GetVoidPointer(0)), held, components);
    const FillFunction<R> fill = [=](int k, const std::vector<BCCBlock<R>>& planes)
    { FillPaddedLayer(this->Kernel, this->QuasiInterpolation, this->Whole, samples, k, planes); };
    StoreFunction<R> store;
    switch (values->GetDataType())
    {
      vtkTemplateMacro(
        store = MakeStore<R>(static_cast<VTK_TT*>(values->GetVoidPointer(0)), width, components));
    }
    BCCCoefficientWindow<R> window(this->GetPaddedExtent(), components, room);
    done = store && this->Run<R>(self, window, fill, store, gradients, begin);
  };
  switch (source->GetDataType())
  {
    vtkTemplateMacro(run(VTK_TT{}));
  }
  return done;
}

} // namespace bravais
