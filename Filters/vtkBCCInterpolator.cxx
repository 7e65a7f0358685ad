// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCInterpolator.h"

#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "BCCKernel.h"
#include "BCCPrefilter.h"
#include "BCCSplineVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

// The layout that the functions of an interpolator are handed. VTK 9.1 and 9.2 have it in
// vtkImageInterpolatorInternals.h, which they do not install; InternalUpdate checks it.
VTK_ABI_NAMESPACE_BEGIN
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
VTK_ABI_NAMESPACE_END

vtkStandardNewMacro(vtkBCCInterpolator);

/// Under a name that the header can announce.
class vtkBCCInterpolator::Coefficients : public bravais::BCCSplineVolume
{
public:
  using BCCSplineVolume::BCCSplineVolume;
};

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
  vtkNew<vtkImageData> image;
  image->SetExtent(this->Extent);
  image->GetPointData()->SetScalars(this->Scalars);
  const bravais::BCCKernel kernel = *bravais::ToBCCKernel(this->Kernel);
  const bravais::BCCPrefilter prefilter = *bravais::ToBCCPrefilter(this->Prefilter);
  if (this->Cache && this->Cache->IsOf(image, kernel, prefilter))
  {
    return true;
  }
  this->Cache.reset();
  if (!bravais::CheckMemory(bravais::BCCSplineVolume::GetPaddedExtent(this->Extent).data(),
        bravais::BCCSplineVolume::GetBytesPerPoint(image), why))
  {
    vtkErrorMacro(<< why);
    return false;
  }
  this->Cache = std::make_shared<Coefficients>(image, kernel, prefilter);
  return true;
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::InternalUpdate()
{
  vtkInterpolationInfo* info = this->InterpolationInfo;
  if (info->Array != this->Scalars || info->Extent[5] != this->Extent[5])
  {
    vtkErrorMacro("This VTK hands interpolators another vtkInterpolationInfo than 9.1 and 9.2 do.");
    info->ExtraInfo = nullptr;
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
void vtkBCCInterpolator::DeepCopy(vtkAbstractImageInterpolator* other)
{
  this->Superclass::DeepCopy(other);
  this->InternalDeepCopy(other);
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
  if (!coefficients)
  {
    // After an error all points are out of bounds, but need not be asked about that.
    std::fill_n(values, info->NumberOfComponents, F(0));
    return;
  }
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
  *function = &EvaluateAll<Coefficients, double>;
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::GetInterpolationFunc(
  void (**function)(vtkInterpolationInfo*, const float[3], float*))
{
  *function = &EvaluateAll<Coefficients, float>;
}

//------------------------------------------------------------------------------
void vtkBCCInterpolator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << this->GetKernelAsString() << "\n";
  os << indent << "Prefilter: " << this->GetPrefilterAsString() << "\n";
}
