// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeInput.h"

#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "vtkBCCCoefficientArray.h"
#include "vtkBCCLattice.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
// Of values whose splines shaders can sum as floats, whose largest is 3.4e38.
constexpr double LargestMagnitude = 1e36;

bool CheckMagnitude(vtkDataArray* scalars, std::string& why)
{
  for (int component = 0; component < scalars->GetNumberOfComponents(); ++component)
  {
    double range[2];
    scalars->GetFiniteRange(range, component);
    const double largest = std::max(-range[0], range[1]);
    if (largest > LargestMagnitude)
    {
      std::ostringstream text;
      text << "The input's scalars are up to " << largest
           << " in magnitude; OpenGL takes floats, and " << LargestMagnitude << " can be rendered.";
      why = text.str();
      return false;
    }
  }
  return true;
}
} // namespace

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
  int whole[6];
  int piece[6];
  const bool part = vtkBCCLattice::GetPiece(image, whole, piece);
  if (!bravais::CheckBCCImage(this->Source, part ? whole : nullptr, why))
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
bool vtkBCCVolumeInput::SetReach(int kernel, int prefilter, const int reach[3], std::string& why)
{
  this->Piece.emplace(this->Source, prefilter);
  return !this->Piece->IsPart ||
    (this->Piece->Check(kernel, prefilter, why) && this->Piece->CheckGhosts(reach, why));
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::CheckTexture(
  int limit, double bytes, bool halfFloats, std::string& why) const
{
  const glm::ivec3 size =
    vtkBCCCoefficientTexels::GetSize(vtkBCCVolumeFrame(this->Source, this->Piece->Coefficients));
  if (std::max({ size.x, size.y, size.z }) > limit)
  {
    why = "The input needs a texture of " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + " x " + std::to_string(size.z) + " texels; OpenGL takes up to " +
      std::to_string(limit) + " along each axis.";
    return false;
  }
  const int components = this->Source->GetPointData()->GetScalars()->GetNumberOfComponents();
  const double needed =
    static_cast<double>(size.x) * size.y * size.z * components * (halfFloats ? 2 : 4);
  if (needed > bytes)
  {
    why = "The input's coefficients need " + std::to_string(std::llround(needed)) +
      " bytes on the GPU; MaxMemoryInBytes times MaxMemoryFraction is " +
      std::to_string(std::llround(bytes)) + ".";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::Load(int kernel, int prefilter, bool halfFloats, std::string& why)
{
  const auto wanted = std::tuple_cat(this->Current, std::make_tuple(kernel, prefilter, halfFloats));
  if (this->Loaded != wanted)
  {
    this->Loaded = wanted;
    this->LoadError.clear();
    this->Frame.reset();
    this->Compute(kernel, prefilter, halfFloats, this->LoadError);
  }
  why = this->LoadError;
  return this->Frame.has_value();
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::Compute(int kernel, int prefilter, bool halfFloats, std::string& why)
{
  this->Bricks.reset();
  vtkDataArray* scalars = this->Source->GetPointData()->GetScalars();
  vtkNew<vtkBCCCoefficientArray> description;
  if (!description->Describe(scalars, this->Source))
  {
    why = "A component of the input's scalars has no finite value.";
    return false;
  }
  if (!CheckMagnitude(description, why))
  {
    return false;
  }
  const int* extent = this->Piece->Coefficients;
  auto coefficients = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(bravais::GetBCCCoefficientType(scalars->GetDataType())));
  coefficients->SetNumberOfComponents(scalars->GetNumberOfComponents());
  const vtkBCCVolumeFrame held(this->Source, extent);
  coefficients->SetNumberOfTuples(held.GetNumberOfPoints());
  bravais::ComputeBCCCoefficients(
    nullptr, this->Source, this->Piece->Whole, kernel, prefilter, coefficients, extent, 0, 1);
  this->Texels.Pack(held, coefficients);
  this->CoefficientError = 0.0;
  if (halfFloats && !this->RoundToHalf(description, why))
  {
    return false;
  }
  const vtkBCCVolumeFrame frame(this->Source, this->Piece->Whole);
  frame.FitStandIn(this->StandIn, this->Piece->IsPart);
  this->StandIn->GetCellData()->SetScalars(description);
  this->Frame = frame;
  this->LoadTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeInput::RoundToHalf(vtkDataArray* scalars, std::string& why)
{
  const std::vector<double> errors = this->Texels.RoundToHalf();
  for (int component = 0; component < this->Texels.Components; ++component)
  {
    double range[2];
    scalars->GetFiniteRange(range, component);
    if (!(errors[component] <= (range[1] - range[0]) / 512.0))
    {
      std::ostringstream text;
      text << "Half floats change the coefficients by up to " << errors[component]
           << "; HalfFloatCoefficients allows up to 1/512 of the scalars' range, "
           << (range[1] - range[0]) / 512.0 << ".";
      why = text.str();
      return false;
    }
    this->CoefficientError = std::max(this->CoefficientError, errors[component]);
  }
  return true;
}

//------------------------------------------------------------------------------
const bravais::BCCBricks& vtkBCCVolumeInput::GetBricks()
{
  if (!this->Bricks)
  {
    const vtkBCCVolumeFrame frame(this->Source, this->Piece->Coefficients);
    const auto kernel = static_cast<bravais::BCCKernel>(std::get<3>(this->Loaded));
    const bravais::BCCTexels texels = { this->Texels.Values.data(), this->Texels.Size,
      this->Texels.Components };
    this->Bricks.emplace(glm::ivec3(frame.High[0], frame.High[1], frame.High[2]),
      static_cast<int>(frame.Low[2]), this->Texels.Components);
    vtkSMPTools::For(0, this->Bricks->GetSize().z,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType layer = begin; layer < end; ++layer)
        {
          this->Bricks->ComputeLayer(kernel, texels, static_cast<int>(layer));
        }
      });
  }
  return *this->Bricks;
}

//------------------------------------------------------------------------------
vtkBCCVolumeFrame vtkBCCVolumeInput::GetHeldFrame() const
{
  vtkBCCVolumeFrame held(this->Source);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int units = axis == 2 ? 1 : 2;
    const double low = units * (this->Piece->Held[2 * axis] - this->Piece->Whole[2 * axis]) +
      (axis == 2 ? this->Piece->Whole[4] & 1 : 0);
    held.High[axis] += low - held.Low[axis];
    held.Low[axis] = low;
  }
  return held;
}

//------------------------------------------------------------------------------
float vtkBCCVolumeInput::GetNormalizer() const
{
  switch (this->Source->GetPointData()->GetScalars()->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return 1.0f / VTK_UNSIGNED_CHAR_MAX;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return 1.0f / VTK_SIGNED_CHAR_MAX;
    case VTK_UNSIGNED_SHORT:
      return 1.0f / VTK_UNSIGNED_SHORT_MAX;
    case VTK_SHORT:
      return 1.0f / VTK_SHORT_MAX;
    case VTK_FLOAT:
      return 1.0f;
    default:
      return 0.0f;
  }
}
