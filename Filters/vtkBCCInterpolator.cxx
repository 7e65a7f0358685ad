// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCInterpolator.h"

#include "BCCBlock.h"
#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "BCCKernel.h"
#include "BCCPaddedLayer.h"
#include "BCCPrefilter.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSplineRows.h"
#include "BoxSpline.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

// The layout that the functions of an interpolator are handed. VTK 9.1 and 9.2 have it in
// vtkImageInterpolatorInternals.h, which they do not install; InternalUpdate checks it.
struct vtkInterpolationInfo
{
  const void* Pointer;
  int Extent[6];
  vtkIdType Increments[3];
  int ScalarType;
  int NumberOfComponents;
  int BorderMode;
  int InterpolationMode;
  void* ExtraInfo;

  vtkDataArray* Array;
  vtkIdType Index;
};

vtkStandardNewMacro(vtkBCCInterpolator);

//------------------------------------------------------------------------------
/// The coefficients of one volume, continued by the mirrors as far as stencils reach.
class vtkBCCInterpolator::Coefficients
{
public:
  vtkSmartPointer<vtkDataArray> Scalars;
  vtkMTimeType Time = 0;
  bravais::BCCExtent Whole;
  bravais::BCCKernel Kernel;
  int Prefilter = 0;

  template <class R>
  std::vector<bravais::BCCBlock<R>>& GetPlanes();
  template <class R>
  const std::vector<bravais::BCCBlock<R>>& GetPlanes() const
  {
    return const_cast<Coefficients*>(this)->GetPlanes<R>();
  }

  void Compute(vtkImageData* image);

  /// Evaluates component c at a point of the box, in lattice coordinates.
  double Evaluate(const glm::dvec3& p, int c) const
  {
    return this->Doubles.empty() ? this->EvaluateIn(this->Floats[c], p)
                                 : this->EvaluateIn(this->Doubles[c], p);
  }

private:
  template <class R>
  double EvaluateIn(const bravais::BCCBlock<R>& plane, const glm::dvec3& p) const
  {
    const R* origin = plane.GetRow(0, 0) - plane.Extent[0];
    const auto fetch = [&](const glm::ivec3& j)
    {
      const int odd = j.z & 1;
      return static_cast<double>(
        origin[(j.x - odd) / 2 + plane.RowStride * ((j.y - odd) / 2) + plane.LayerStride * j.z]);
    };
    glm::dvec3 gradient;
    return bravais::EvaluateBoxSpline(this->Kernel, fetch, p, gradient);
  }

  template <class T>
  void Fill(const T* samples, const bravais::BCCExtent& held, int components);

  std::vector<char> Memory;
  std::vector<bravais::BCCBlock<float>> Floats;
  std::vector<bravais::BCCBlock<double>> Doubles;
};

template <>
std::vector<bravais::BCCBlock<float>>& vtkBCCInterpolator::Coefficients::GetPlanes<float>()
{
  return this->Floats;
}

template <>
std::vector<bravais::BCCBlock<double>>& vtkBCCInterpolator::Coefficients::GetPlanes<double>()
{
  return this->Doubles;
}

//------------------------------------------------------------------------------
template <class T>
void vtkBCCInterpolator::Coefficients::Fill(
  const T* samples, const bravais::BCCExtent& held, int components)
{
  using R = bravais::BCCCoefficient<T>;
  bravais::BCCExtent padded = this->Whole;
  for (int axis = 0; axis < 3; ++axis)
  {
    padded[2 * axis] -= bravais::BCCReachBelow[axis];
    padded[2 * axis + 1] += bravais::BCCReachAbove[axis];
  }
  const bravais::BCCBlock<const T> block(samples, held, components);
  bravais::BCCBlock<R> plane(nullptr, padded);
  const std::size_t size = static_cast<std::size_t>(plane.LayerStride) *
    static_cast<std::size_t>(padded[5] - padded[4] + 1);
  this->Memory.resize(size * static_cast<std::size_t>(components) * sizeof(R));
  auto& planes = this->GetPlanes<R>();
  for (int c = 0; c < components; ++c)
  {
    plane.Data = reinterpret_cast<R*>(this->Memory.data()) + static_cast<std::size_t>(c) * size;
    planes.push_back(plane);
  }
  const bool local = this->Prefilter == static_cast<int>(bravais::BCCPrefilter::QuasiInterpolation);
  vtkSMPTools::For(padded[4], vtkIdType{ padded[5] } + 1, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        bravais::FillPaddedLayer(
          this->Kernel, local, this->Whole, block, static_cast<int>(k), planes);
      }
    });
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::Coefficients::Compute(vtkImageData* image)
{
  vtkSmartPointer<vtkDataArray> source = this->Scalars;
  if (bravais::NeedsWholeVolume(this->Prefilter))
  {
    const int type = bravais::GetBCCCoefficientType(source->GetDataType());
    source.TakeReference(vtkDataArray::CreateDataArray(type));
    source->SetNumberOfComponents(this->Scalars->GetNumberOfComponents());
    source->SetNumberOfTuples(this->Scalars->GetNumberOfTuples());
    bravais::ComputeBCCCoefficients(nullptr, image, this->Whole.data(),
      static_cast<int>(this->Kernel), this->Prefilter, source, this->Whole.data(), 0.0, 1.0);
  }
  switch (source->GetDataType())
  {
    vtkTemplateMacro(this->Fill(static_cast<const VTK_TT*>(source->GetVoidPointer(0)), this->Whole,
      source->GetNumberOfComponents()));
  }
}

namespace
{

/// Moves a coordinate that lies beyond first .. first + length into it.
double MoveInside(double x, double first, double length, int mode)
{
  const double offset = x - first;
  if (offset >= 0.0 && offset <= length)
  {
    return x;
  }
  switch (mode)
  {
    case VTK_IMAGE_BORDER_REPEAT:
      return first + (offset - length * std::floor(offset / length));
    case VTK_IMAGE_BORDER_MIRROR:
    {
      const double rest = offset - 2.0 * length * std::floor(offset / (2.0 * length));
      return first + (rest > length ? 2.0 * length - rest : rest);
    }
    default:
      return offset > 0.0 ? first + length : first; // not-a-number becomes the first
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkBCCInterpolator::~vtkBCCInterpolator() = default;

//------------------------------------------------------------------------------
const char* vtkBCCInterpolator::GetKernelAsString()
{
  const auto kernel = bravais::ToBCCKernel(this->Kernel);
  return kernel ? bravais::GetName(*kernel) : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkBCCInterpolator::GetPrefilterAsString()
{
  const auto prefilter = bravais::ToBCCPrefilter(this->Prefilter);
  return prefilter ? bravais::GetName(*prefilter) : "Unknown";
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::Initialize(vtkDataObject* data)
{
  std::string why;
  if (!bravais::CheckBCCImage(vtkImageData::SafeDownCast(data), why))
  {
    vtkErrorMacro(<< why);
    this->ReleaseData();
    this->Update();
    this->SetEmptyBounds();
    return;
  }
  this->Superclass::Initialize(data);
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::SetEmptyBounds()
{
  for (int n = 0; n < 6; ++n)
  {
    this->StructuredBoundsDouble[n] = n % 2 ? 0.0 : 1.0;
    this->StructuredBoundsFloat[n] = n % 2 ? 0.0f : 1.0f;
  }
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::ComputeSupportSize(const double*, int support[3])
{
  // VTK asks upstream for a point's index, (size + 1) / 2 - 1 more below and one more above. All,
  // that is more than any volume has, but can be added to an index.
  constexpr int all = 1 << 28;
  const bool whole = bravais::NeedsWholeVolume(this->Prefilter);
  support[0] = whole ? all : 8;
  support[1] = whole ? all : 8;
  support[2] = whole ? all : 12;
}

//------------------------------------------------------------------------------
bool vtkBCCInterpolator::Prepare()
{
  std::string why;
  if (!bravais::CheckBCCSpline(this->Kernel, this->Prefilter, why))
  {
    vtkErrorMacro(<< why);
    return false;
  }
  const bravais::BCCExtent whole = bravais::ToBCCExtent(this->Extent);
  const Coefficients* old = this->Cache.get();
  if (old && old->Scalars == this->Scalars && old->Time == this->Scalars->GetMTime() &&
    old->Whole == whole && static_cast<int>(old->Kernel) == this->Kernel &&
    old->Prefilter == this->Prefilter)
  {
    return true;
  }
  this->Cache.reset();
  auto fresh = std::make_shared<Coefficients>();
  fresh->Scalars = this->Scalars;
  fresh->Time = this->Scalars->GetMTime();
  fresh->Whole = whole;
  fresh->Kernel = *bravais::ToBCCKernel(this->Kernel);
  fresh->Prefilter = this->Prefilter;
  vtkNew<vtkImageData> image;
  image->SetExtent(this->Extent);
  image->GetPointData()->SetScalars(this->Scalars);
  fresh->Compute(image);
  this->Cache = fresh;
  return true;
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::InternalUpdate()
{
  vtkInterpolationInfo* info = this->InterpolationInfo;
  if (info->Array != this->Scalars || info->Extent[5] != this->Extent[5])
  {
    vtkErrorMacro("This VTK hands interpolators another vtkInterpolationInfo than 9.1 and 9.2 do.");
    this->SetEmptyBounds();
    return;
  }
  if (!this->Prepare())
  {
    info->ExtraInfo = nullptr;
    this->SetEmptyBounds();
    return;
  }
  info->ExtraInfo = const_cast<Coefficients*>(this->Cache.get());
  // The box ends half a spacing after the last index along x and y.
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = this->Extent[2 * axis] - this->Tolerance;
    const double high = this->Extent[2 * axis + 1] + (axis < 2 ? 0.5 : 0.0) + this->Tolerance;
    this->StructuredBoundsDouble[2 * axis] = low;
    this->StructuredBoundsDouble[2 * axis + 1] = high;
    this->StructuredBoundsFloat[2 * axis] = static_cast<float>(low);
    this->StructuredBoundsFloat[2 * axis + 1] = static_cast<float>(high);
  }
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::InternalDeepCopy(vtkAbstractImageInterpolator* other)
{
  if (vtkBCCInterpolator* source = vtkBCCInterpolator::SafeDownCast(other))
  {
    this->SetKernel(source->Kernel);
    this->SetPrefilter(source->Prefilter);
    this->Cache = source->Cache;
  }
}

namespace
{
template <class C, class F>
void EvaluateAll(vtkInterpolationInfo* info, const F point[3], F* values)
{
  const C* coefficients = static_cast<const C*>(info->ExtraInfo);
  const int* e = info->Extent;
  const glm::dvec3 p(
    MoveInside(2.0 * point[0], 2.0 * e[0], 2.0 * (e[1] - e[0]) + 1.0, info->BorderMode),
    MoveInside(2.0 * point[1], 2.0 * e[2], 2.0 * (e[3] - e[2]) + 1.0, info->BorderMode),
    MoveInside(point[2], e[4], e[5] - e[4], info->BorderMode));
  // VTK selects a component by moving the pointer to its first value.
  const std::ptrdiff_t bytes = static_cast<const char*>(info->Pointer) -
    static_cast<const char*>(info->Array->GetVoidPointer(0));
  const int first = static_cast<int>(bytes / info->Array->GetDataTypeSize());
  for (int c = 0; c < info->NumberOfComponents; ++c)
  {
    values[c] = static_cast<F>(coefficients->Evaluate(p, first + c));
  }
}
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::GetInterpolationFunc(
  void (**function)(vtkInterpolationInfo*, const double[3], double*))
{
  if (this->InterpolationInfo->ExtraInfo)
  {
    *function = &EvaluateAll<Coefficients, double>;
  }
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::GetInterpolationFunc(
  void (**function)(vtkInterpolationInfo*, const float[3], float*))
{
  if (this->InterpolationInfo->ExtraInfo)
  {
    *function = &EvaluateAll<Coefficients, float>;
  }
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << this->GetKernelAsString() << "\n";
  os << indent << "Prefilter: " << this->GetPrefilterAsString() << "\n";
}
