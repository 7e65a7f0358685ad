// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerSampler.h"

#include "BCCLattice.h"
#include "BCCPlacement.h"
#include "BSplineSampler.h"

#include "vtkImageBSplineCoefficients.h"
#include "vtkImageBSplineInterpolator.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bravais
{
namespace
{

static_assert(static_cast<int>(BSplineBorder::Clamp) == VTK_IMAGE_BORDER_CLAMP &&
    static_cast<int>(BSplineBorder::Repeat) == VTK_IMAGE_BORDER_REPEAT &&
    static_cast<int>(BSplineBorder::Mirror) == VTK_IMAGE_BORDER_MIRROR,
  "The borders are VTK's.");

template <class T>
class SplineLayers : public LayerSampler
{
public:
  SplineLayers(vtkImageData* coefficients, vtkImageBSplineInterpolator* spline,
    const BCCPlacement& placement, const int extent[6])
    : FirstLayer(extent[4])
    , Stride(coefficients->GetNumberOfScalarComponents())
    , Components(spline->ComputeNumberOfComponents(this->Stride))
  {
    coefficients->GetDimensions(&this->Dimensions.x);
    const int offset = std::clamp(spline->GetComponentOffset(), 0, this->Stride - 1);
    this->Coefficients = static_cast<const T*>(coefficients->GetScalarPointer()) + offset;
    for (int coset = 0; coset < 2; ++coset)
    {
      double matrix[16];
      placement.GetMatrix(coset, matrix);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double start = matrix[4 * axis + 3] - coefficients->GetExtent()[2 * axis];
        this->Axes[coset].emplace_back(spline->GetSplineDegree(),
          static_cast<BSplineBorder>(spline->GetBorderMode()), this->Dimensions[axis], start,
          matrix[5 * axis], extent[2 * axis], extent[2 * axis + 1]);
      }
    }
  }

  const std::vector<double>& Sample(int k) override
  {
    const int coset = BCCLattice::GetCoset(k);
    const std::vector<BSplineAxis>& axes = this->Axes[coset];
    std::shared_ptr<BSplineSampler<T>>& sampler = this->Locals.Local()[coset];
    if (!sampler)
    {
      sampler =
        std::make_shared<BSplineSampler<T>>(this->Coefficients, this->Dimensions, this->Stride,
          this->Components, std::array<const BSplineAxis*, 3>{ &axes[0], &axes[1], &axes[2] });
    }
    return sampler->Evaluate(k - this->FirstLayer);
  }

private:
  int FirstLayer;
  int Stride;
  int Components;
  glm::ivec3 Dimensions;
  const T* Coefficients;
  std::vector<BSplineAxis> Axes[2];                                            // of each coset
  vtkSMPThreadLocal<std::array<std::shared_ptr<BSplineSampler<T>>, 2>> Locals; // of each coset
};

class InterpolatorLayers : public LayerSampler
{
public:
  InterpolatorLayers(vtkImageData* image, vtkAbstractImageInterpolator* interpolator,
    const BCCPlacement& placement, const int extent[6])
    : Interpolator(interpolator)
  {
    interpolator->Initialize(image);
    interpolator->Update();
    this->Components = interpolator->GetNumberOfComponents();
    std::copy_n(extent, 6, this->Extent);
    placement.GetMatrix(0, this->Matrix[0]);
    placement.GetMatrix(1, this->Matrix[1]);
  }

  ~InterpolatorLayers() override
  {
    for (Scratch& local : this->Locals)
    {
      for (vtkInterpolationWeights*& weights : local.OfCoset)
      {
        if (weights)
        {
          this->Interpolator->FreePrecomputedWeights(weights);
        }
      }
    }
    this->Interpolator->ReleaseData();
  }

  const std::vector<double>& Sample(int k) override
  {
    Scratch& local = this->Locals.Local();
    const int coset = BCCLattice::GetCoset(k);
    const double* matrix = this->Matrix[coset];
    const int* e = this->Extent;
    const int count = e[1] - e[0] + 1;
    const std::size_t row = static_cast<std::size_t>(count) * this->Components;
    local.Values.resize(row * (e[3] - e[2] + 1));
    vtkInterpolationWeights*& weights = local.OfCoset[coset];
    if (!weights && this->Interpolator->IsSeparable())
    {
      int inside[6];
      this->Interpolator->PrecomputeWeightsForExtent(matrix, e, inside, weights);
    }
    double* out = local.Values.data();
    for (int j = e[2]; j <= e[3]; ++j, out += row)
    {
      if (weights)
      {
        this->Interpolator->InterpolateRow(weights, e[0], j, k, out, count);
        continue;
      }
      for (int i = 0; i < count; ++i)
      {
        const double point[3] = { matrix[0] * (e[0] + i) + matrix[3], matrix[5] * j + matrix[7],
          matrix[10] * k + matrix[11] };
        this->Interpolator->InterpolateIJK(
          point, out + static_cast<std::size_t>(i) * this->Components);
      }
    }
    return local.Values;
  }

private:
  struct Scratch // an interpolator may keep sums with its weights, so every thread has its own
  {
    vtkInterpolationWeights* OfCoset[2] = { nullptr, nullptr };
    std::vector<double> Values;
  };

  vtkAbstractImageInterpolator* Interpolator;
  int Components;
  int Extent[6];
  double Matrix[2][16];
  vtkSMPThreadLocal<Scratch> Locals;
};

} // namespace

//------------------------------------------------------------------------------
bool NeedsCoefficients(vtkAbstractImageInterpolator* interpolator)
{
  auto* spline = vtkImageBSplineInterpolator::SafeDownCast(interpolator);
  return spline && spline->GetSplineDegree() > 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ComputeCoefficients(
  vtkImageData* image, vtkAbstractImageInterpolator* interpolator, int outputScalarType)
{
  vtkNew<vtkImageData> alone; // so that the input's own pipeline is not touched
  alone->CopyStructure(image);
  alone->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  vtkNew<vtkImageBSplineCoefficients> coefficients;
  coefficients->SetInputData(alone);
  coefficients->SetSplineDegree(
    vtkImageBSplineInterpolator::SafeDownCast(interpolator)->GetSplineDegree());
  coefficients->SetBorderMode(interpolator->GetBorderMode());
  coefficients->SetOutputScalarType(outputScalarType);
  coefficients->SetEnableSMP(true);
  coefficients->Update();
  return coefficients->GetOutput();
}

//------------------------------------------------------------------------------
std::unique_ptr<LayerSampler> MakeLayerSampler(vtkImageData* image,
  vtkAbstractImageInterpolator* interpolator, const BCCPlacement& placement, const int extent[6])
{
  if (!NeedsCoefficients(interpolator))
  {
    return std::make_unique<InterpolatorLayers>(image, interpolator, placement, extent);
  }
  auto* spline = vtkImageBSplineInterpolator::SafeDownCast(interpolator);
  if (image->GetScalarType() == VTK_FLOAT)
  {
    return std::make_unique<SplineLayers<float>>(image, spline, placement, extent);
  }
  return std::make_unique<SplineLayers<double>>(image, spline, placement, extent);
}

} // namespace bravais
