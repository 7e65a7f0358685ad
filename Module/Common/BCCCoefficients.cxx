// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCCoefficients.h"

#include "BCCPrefilter.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSpectralPrefilter.h"
#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <type_traits>

namespace bravais
{

namespace
{

bool ForEachLayer(vtkAlgorithm* self, int first, int last, const std::function<void(int)>& work,
  double begin, double end)
{
  if (self)
  {
    return ForEachSlice(self, first, last, work, begin, end);
  }
  vtkSMPTools::For(first, vtkIdType{ last } + 1, 1,
    [&](vtkIdType from, vtkIdType to)
    {
      for (vtkIdType k = from; k < to; ++k)
      {
        work(static_cast<int>(k));
      }
    });
  return true;
}

template <class T, class R>
void CopyLayer(const BCCBlock<const T>& from, const BCCBlock<R>& to, int k)
{
  const BCCExtent& e = to.Extent;
  const std::int64_t size = (std::int64_t{ e[1] } - e[0] + 1) * to.Components;
  for (int j = e[2]; j <= e[3]; ++j)
  {
    const T* source = from.GetRow(j, k) + (std::int64_t{ e[0] } - from.Extent[0]) * from.Components;
    std::transform(source, source + size, to.GetRow(j, k), [](T v) { return static_cast<R>(v); });
  }
}

/// Whether numbers are finite: of all others the exponent has no bit that is 0, so that one more
/// makes it overflow. Compilers do so with many at once, unlike comparisons of floats.
template <class R>
bool AreFinite(const R* values, std::int64_t count)
{
  using Bits = std::conditional_t<sizeof(R) == 4, std::uint32_t, std::uint64_t>;
  constexpr int fraction = std::numeric_limits<R>::digits - 1;
  constexpr Bits sign = Bits{ 1 } << (8 * sizeof(R) - 1);
  constexpr Bits one = Bits{ 1 } << fraction;
  constexpr Bits exponent = sign - one;
  Bits sum = 0;
  for (std::int64_t n = 0; n < count; ++n)
  {
    Bits bits;
    std::memcpy(&bits, values + n, sizeof(R));
    sum |= (bits & exponent) + one;
  }
  return (sum & sign) == 0;
}

/// The same of an array of floats or doubles.
bool AreFinite(vtkDataArray* array)
{
  std::atomic<bool> finite(true);
  const void* data = array->GetVoidPointer(0);
  vtkSMPTools::For(0, array->GetNumberOfValues(),
    [&](vtkIdType begin, vtkIdType end)
    {
      if (array->GetDataType() == VTK_DOUBLE
          ? !AreFinite(static_cast<const double*>(data) + begin, end - begin)
          : !AreFinite(static_cast<const float*>(data) + begin, end - begin))
      {
        finite = false;
      }
    });
  return finite;
}

template <class T, class R>
bool Compute(vtkAlgorithm* self, const BCCExtent& whole, BCCKernel kernel, BCCPrefilter prefilter,
  const BCCBlock<const T>& samples, const BCCBlock<R>& coefficients, double begin, double end,
  std::atomic<bool>* finite)
{
  const BCCExtent& extent = coefficients.Extent;
  const auto layer = [&](int k)
  {
    if (prefilter != BCCPrefilter::QuasiInterpolation)
    {
      CopyLayer(samples, coefficients, k);
      return;
    }
    BCCBlock<R> one = coefficients;
    one.Data = coefficients.GetRow(extent[2], k);
    one.Extent[4] = one.Extent[5] = k;
    QuasiInterpolate(kernel, whole, samples, one);
    // While the layer is still in the processor's cache.
    const std::int64_t columns = std::int64_t{ extent[1] } - extent[0] + 1;
    const std::int64_t rows = std::int64_t{ extent[3] } - extent[2] + 1;
    if (finite && !AreFinite(one.Data, columns * rows * one.Components))
    {
      *finite = false;
    }
  };
  // A spline of BCC4 passes through its coefficients.
  const bool spectral = NeedsWholeVolume(static_cast<int>(prefilter)) &&
    !(kernel == BCCKernel::BCC4 && prefilter == BCCPrefilter::Interpolation);
  const double copied = spectral ? begin + 0.05 * (end - begin) : end;
  if (!ForEachLayer(self, extent[4], extent[5], layer, begin, copied) || !spectral)
  {
    return !self || !self->GetAbortExecute();
  }
  const auto parallel = [](std::int64_t first, std::int64_t last, const auto& body)
  { vtkSMPTools::For(first, last, [&](vtkIdType b, vtkIdType e) { body(b, e); }); };
  const auto progress = [&](double share)
  {
    if (self)
    {
      self->UpdateProgress(copied + share * (end - copied));
    }
    return !self || !self->GetAbortExecute();
  };
  return ApplySpectralPrefilter(kernel, prefilter, coefficients, parallel, progress);
}

} // namespace

//------------------------------------------------------------------------------
bool CheckBCCSpline(int kernel, int prefilter, std::string& why)
{
  const auto knownKernel = ToBCCKernel(kernel);
  if (!knownKernel)
  {
    why = "Kernel is " + std::to_string(kernel) + "; 4, 7, 8 or 12 (BCC4 to BCC12) was expected.";
    return false;
  }
  const auto knownPrefilter = ToBCCPrefilter(prefilter);
  if (!knownPrefilter)
  {
    why = "Prefilter is " + std::to_string(prefilter) +
      "; 0 (None), 1 (QuasiInterpolation), 2 (Interpolation) or 3 (Projection) was expected.";
    return false;
  }
  if (!IsDefined(*knownKernel, *knownPrefilter))
  {
    why = std::string("Prefilter Interpolation is not defined for the kernel ") +
      GetName(*knownKernel) +
      ": its shifts are linearly dependent (with alternating signs on the two cosets they sum to "
      "zero), so no coefficients make the spline pass through all samples. BCC4 and BCC8 have it; "
      "Projection is the best for this kernel.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int GetBCCCoefficientType(int scalarType)
{
  const bool wide = scalarType == VTK_DOUBLE ||
    (scalarType != VTK_FLOAT && vtkDataArray::GetDataTypeSize(scalarType) == 8);
  return wide ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
bool NeedsWholeVolume(int prefilter)
{
  return prefilter == static_cast<int>(BCCPrefilter::Interpolation) ||
    prefilter == static_cast<int>(BCCPrefilter::Projection);
}

//------------------------------------------------------------------------------
BCCExtent ToBCCExtent(const int extent[6])
{
  return { extent[0], extent[1], extent[2], extent[3], extent[4], extent[5] };
}

//------------------------------------------------------------------------------
bool ComputeBCCCoefficients(vtkAlgorithm* self, vtkImageData* image, const int whole[6], int kernel,
  int prefilter, vtkDataArray* coefficients, const int extent[6], double begin, double end,
  std::atomic<bool>* finite)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int components = scalars->GetNumberOfComponents();
  const BCCExtent held = ToBCCExtent(image->GetExtent());
  bool done = false;
  const auto run = [&](auto sample)
  {
    using T = decltype(sample);
    using R = BCCCoefficient<T>;
    const BCCBlock<const T> samples(
      static_cast<const T*>(scalars->GetVoidPointer(0)), held, components);
    const BCCBlock<R> target(
      static_cast<R*>(coefficients->GetVoidPointer(0)), ToBCCExtent(extent), components);
    done = Compute<T, R>(self, ToBCCExtent(whole), *ToBCCKernel(kernel), *ToBCCPrefilter(prefilter),
      samples, target, begin, end, finite);
  };
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(run(VTK_TT{}));
  }
  if (done && finite && NeedsWholeVolume(prefilter) && !AreFinite(coefficients))
  {
    *finite = false;
  }
  return done;
}

//------------------------------------------------------------------------------
std::string ExplainBCCCoefficients(vtkDataArray* samples, vtkDataArray* coefficients)
{
  const int type = samples->GetDataType();
  if ((type == VTK_FLOAT || type == VTK_DOUBLE) && !AreFinite(samples))
  {
    return {};
  }
  double largest = 0.0;
  for (int component = 0; component < samples->GetNumberOfComponents(); ++component)
  {
    double range[2];
    samples->GetRange(range, component);
    largest = std::max({ largest, std::abs(range[0]), std::abs(range[1]) });
  }
  std::ostringstream text;
  text << "The samples reach " << largest << ", and their coefficients are beyond what "
       << coefficients->GetDataTypeAsString() << " holds; smaller samples were expected.";
  return text.str();
}

} // namespace bravais
