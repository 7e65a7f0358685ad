// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCResample.h"

#include "BCCLowPass.h"
#include "BCCPlacement.h"
#include "LayerSampler.h"
#include "RoundTo.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <memory>
#include <vector>

namespace bravais
{
namespace
{

template <class T>
bool WriteLayers(
  vtkAlgorithm* self, LayerSampler& sampler, vtkImageData* output, double begin, double end)
{
  int e[6];
  output->GetExtent(e);
  T* values = static_cast<T*>(output->GetScalarPointer());
  const vtkIdType size = static_cast<vtkIdType>(e[1] - e[0] + 1) * (e[3] - e[2] + 1) *
    output->GetNumberOfScalarComponents();
  const auto layer = [&](int k)
  {
    T* out = values + size * (k - e[4]);
    for (const double value : sampler.Sample(k))
    {
      *out++ = RoundTo<T>(value);
    }
  };
  return ForEachSlice(self, e[4], e[5], layer, begin, end);
}

template <class T>
void GetComponent(vtkDataArray* array, int component, vtkIdType first, vtkIdType count, T* values)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = static_cast<T>(array->GetComponent(first + i, component));
  }
}

template <class T>
bool FilterComponents(vtkAlgorithm* self, vtkImageData* image, const BCCPlacement& placement,
  vtkImageData* result, double begin, double end)
{
  int n[3];
  image->GetDimensions(n);
  const vtkIdType layer = static_cast<vtkIdType>(n[0]) * n[1];
  const BCCLowPass lowPass({ n[0], n[1], n[2] },
    1.0 / glm::dvec3(placement.Step[0], placement.Step[1], placement.Step[2]));
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int components = scalars->GetNumberOfComponents();
  T* filtered = static_cast<T*>(result->GetScalarPointer());
  std::vector<T> one(components > 1 ? layer * n[2] : 0);
  T* samples = components > 1 ? one.data() : filtered;

  constexpr int stages = BCCLowPass::NumberOfPasses;
  const double share = (end - begin) / (components * stages);
  for (int c = 0; c < components; ++c)
  {
    for (int pass = 0; pass < stages; ++pass, begin += share)
    {
      const auto part = [&](int p)
      {
        T* values = samples + p * layer;
        if (pass == 0)
        {
          GetComponent(scalars, c, p * layer, layer, values);
        }
        lowPass.Apply(pass, p, samples);
        for (vtkIdType i = 0; components > 1 && pass == 2 && i < layer; ++i)
        {
          filtered[(p * layer + i) * components + c] = values[i];
        }
      };
      if (!ForEachSlice(self, 0, lowPass.GetNumberOfParts(pass) - 1, part, begin, begin + share))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
int GetArithmeticType(int scalarType)
{
  const bool wide = scalarType == VTK_DOUBLE ||
    (scalarType != VTK_FLOAT && vtkDataArray::GetDataTypeSize(scalarType) == 8);
  return wide ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> FilterLowPass(
  vtkAlgorithm* self, vtkImageData* image, const BCCPlacement& placement, double begin, double end)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  const int type = GetArithmeticType(image->GetScalarType());
  result->AllocateScalars(type, image->GetNumberOfScalarComponents());
  const bool finished = type == VTK_FLOAT
    ? FilterComponents<float>(self, image, placement, result, begin, end)
    : FilterComponents<double>(self, image, placement, result, begin, end);
  return finished ? result : nullptr;
}

//------------------------------------------------------------------------------
bool Interpolate(vtkAlgorithm* self, vtkImageData* image,
  vtkAbstractImageInterpolator* interpolator, const BCCPlacement& placement, vtkImageData* output,
  double begin, double end)
{
  const std::unique_ptr<LayerSampler> sampler =
    MakeLayerSampler(image, interpolator, placement, output->GetExtent());
  bool finished = false;
  switch (output->GetScalarType())
  {
    vtkTemplateMacro(finished = WriteLayers<VTK_TT>(self, *sampler, output, begin, end));
  }
  return finished;
}

} // namespace bravais
