// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCSplineVolume.h"

#include "BCCCoefficients.h"
#include "BCCPaddedLayer.h"
#include "BCCQuasiInterpolation.h"
#include "BCCSplineRows.h"
#include "BoxSpline.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <type_traits>

namespace bravais
{

//------------------------------------------------------------------------------
BCCSplineVolume::BCCSplineVolume(vtkImageData* image, BCCKernel kernel, BCCPrefilter prefilter)
  : Whole(ToBCCExtent(image->GetExtent()))
  , Kernel(kernel)
  , Prefilter(prefilter)
  , Time(image->GetPointData()->GetScalars()->GetMTime())
{
  vtkSmartPointer<vtkDataArray> source = image->GetPointData()->GetScalars();
  const int components = source->GetNumberOfComponents();
  if (NeedsWholeVolume(static_cast<int>(prefilter)))
  {
    vtkSmartPointer<vtkDataArray> filtered;
    filtered.TakeReference(
      vtkDataArray::CreateDataArray(GetBCCCoefficientType(source->GetDataType())));
    filtered->SetNumberOfComponents(components);
    filtered->SetNumberOfTuples(image->GetNumberOfPoints());
    ComputeBCCCoefficients(nullptr, image, this->Whole.data(), static_cast<int>(kernel),
      static_cast<int>(prefilter), filtered, this->Whole.data(), 0.0, 1.0);
    source = filtered;
  }
  switch (source->GetDataType())
  {
    vtkTemplateMacro(this->Fill(static_cast<const VTK_TT*>(source->GetVoidPointer(0)), components));
  }
}

//------------------------------------------------------------------------------
template <class T>
void BCCSplineVolume::Fill(const T* samples, int components)
{
  using R = BCCCoefficient<T>;
  std::vector<R>* memory;
  std::vector<BCCBlock<R>>* planes;
  if constexpr (std::is_same_v<R, float>)
  {
    memory = &this->FloatMemory;
    planes = &this->FloatPlanes;
  }
  else
  {
    memory = &this->DoubleMemory;
    planes = &this->DoublePlanes;
  }
  const BCCExtent padded = GetPaddedExtent(this->Whole.data());
  BCCBlock<R> plane(nullptr, padded);
  const std::size_t size = static_cast<std::size_t>(plane.LayerStride) *
    static_cast<std::size_t>(padded[5] - padded[4] + 1);
  memory->resize(size * static_cast<std::size_t>(components));
  for (int c = 0; c < components; ++c)
  {
    plane.Data = memory->data() + static_cast<std::size_t>(c) * size;
    planes->push_back(plane);
  }
  const BCCBlock<const T> block(samples, this->Whole, components);
  const bool local = this->Prefilter == BCCPrefilter::QuasiInterpolation;
  vtkSMPTools::For(padded[4], vtkIdType{ padded[5] } + 1, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        FillPaddedLayer(this->Kernel, local, this->Whole, block, static_cast<int>(k), *planes);
      }
    });
}

//------------------------------------------------------------------------------
bool BCCSplineVolume::IsOf(vtkImageData* image, BCCKernel kernel, BCCPrefilter prefilter) const
{
  return this->Time == image->GetPointData()->GetScalars()->GetMTime() &&
    this->Whole == ToBCCExtent(image->GetExtent()) && this->Kernel == kernel &&
    this->Prefilter == prefilter;
}

//------------------------------------------------------------------------------
template <class R>
double BCCSplineVolume::EvaluateIn(const BCCBlock<R>& plane, const glm::dvec3& p) const
{
  const std::int64_t origin = -(plane.Extent[0] + plane.RowStride * plane.Extent[2] +
    plane.LayerStride * plane.Extent[4]); // of index (0, 0, 0), which may be elsewhere
  const auto fetch = [&](const glm::ivec3& j)
  {
    const int odd = j.z & 1;
    return static_cast<double>(plane.Data[origin + (j.x - odd) / 2 +
      plane.RowStride * ((j.y - odd) / 2) + plane.LayerStride * j.z]);
  };
  glm::dvec3 gradient;
  return EvaluateBoxSpline(this->Kernel, fetch, p, gradient);
}

//------------------------------------------------------------------------------
double BCCSplineVolume::Evaluate(const glm::dvec3& p, int component) const
{
  const auto c = static_cast<std::size_t>(component);
  return this->DoublePlanes.empty() ? this->EvaluateIn(this->FloatPlanes[c], p)
                                    : this->EvaluateIn(this->DoublePlanes[c], p);
}

//------------------------------------------------------------------------------
int BCCSplineVolume::GetBytesPerPoint(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return scalars->GetNumberOfComponents() *
    vtkDataArray::GetDataTypeSize(GetBCCCoefficientType(scalars->GetDataType()));
}

//------------------------------------------------------------------------------
BCCExtent BCCSplineVolume::GetPaddedExtent(const int whole[6])
{
  BCCExtent padded = ToBCCExtent(whole);
  for (int axis = 0; axis < 3; ++axis)
  {
    padded[2 * axis] -= BCCReachBelow[axis];
    padded[2 * axis + 1] += BCCReachAbove[axis];
  }
  return padded;
}

} // namespace bravais
