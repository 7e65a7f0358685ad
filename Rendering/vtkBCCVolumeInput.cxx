// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeInput.h"

#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "vtkBCCCoefficientArray.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

vtkBCCVolumeInput::vtkBCCVolumeInput() = default;
vtkBCCVolumeInput::~vtkBCCVolumeInput() = default;

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::SetSource(vtkImageData* image, vtkDataArray* scalars, std::string& why)
{
  if (!image)
  {
    return bravais::CheckBCCImage(nullptr, why);
  }
  this->Source->ShallowCopy(image);
  this->Source->GetPointData()->SetScalars(scalars);
  if (!bravais::CheckBCCImage(this->Source, why))
  {
    return false;
  }
  const int components = scalars->GetNumberOfComponents();
  if (components > 4)
  {
    why = "The input's scalars have " + std::to_string(components) +
      " components; 1 to 4 can be rendered.";
    return false;
  }
  this->Current = { image, image->GetMTime(), scalars };
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::CheckTexture(int limit, std::string& why) const
{
  const glm::ivec3 size = vtkBCCCoefficientTexels::GetSize(vtkBCCVolumeFrame(this->Source));
  if (std::max({ size.x, size.y, size.z }) > limit)
  {
    why = "The input needs a texture of " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + " x " + std::to_string(size.z) + " texels; OpenGL takes up to " +
      std::to_string(limit) + " along each axis.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::Load(int kernel, int prefilter, std::string& why)
{
  const auto wanted = std::tuple_cat(this->Current, std::make_tuple(kernel, prefilter));
  if (this->Frame && this->Loaded == wanted)
  {
    return true;
  }
  this->Frame.reset();
  vtkDataArray* scalars = this->Source->GetPointData()->GetScalars();
  vtkNew<vtkBCCCoefficientArray> description;
  if (!description->Describe(scalars))
  {
    why = "A component of the input's scalars has no finite value.";
    return false;
  }
  const int* extent = this->Source->GetExtent();
  auto coefficients = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(bravais::GetBCCCoefficientType(scalars->GetDataType())));
  coefficients->SetNumberOfComponents(scalars->GetNumberOfComponents());
  coefficients->SetNumberOfTuples(this->Source->GetNumberOfPoints());
  bravais::ComputeBCCCoefficients(
    nullptr, this->Source, extent, kernel, prefilter, coefficients, extent, 0, 1);
  const vtkBCCVolumeFrame frame(this->Source);
  this->Texels.Pack(frame, coefficients);
  frame.FitStandIn(this->StandIn);
  this->StandIn->GetCellData()->SetScalars(description);
  this->Frame = frame;
  this->Loaded = wanted;
  this->LoadTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
float vtkBCCVolumeInput::GetNormalizer() const
{
  switch (this->Source->GetPointData()->GetScalars()->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return 1.0f / VTK_UNSIGNED_CHAR_MAX;
    case VTK_SIGNED_CHAR:
      return 1.0f / VTK_SIGNED_CHAR_MAX;
    case VTK_UNSIGNED_SHORT:
      return 1.0f / VTK_UNSIGNED_SHORT_MAX;
    case VTK_SHORT:
      return 1.0f / VTK_SHORT_MAX;
    default:
      return 1.0f;
  }
}
