// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeMask.h"

#include "vtkBCCLattice.h"
#include "vtkBCCMaskLabels.h"
#include "vtkBCCVolumeFrame.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace
{
bool HasCountsOf(vtkImageData* mask, const vtkBCCVolumeFrame& volume)
{
  int extent[6];
  mask->GetExtent(extent);
  bool same = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    same = same &&
      extent[2 * axis + 1] - extent[2 * axis] ==
        volume.Extent[2 * axis + 1] - volume.Extent[2 * axis];
  }
  return same && mask->GetPointData()->GetScalars();
}

// Multiplies each row by a factor and adds an offset.
void ScaleRows(vtkMatrix4x4* matrix, const double factors[3], const double offsets[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(axis, column, factors[axis] * matrix->GetElement(axis, column));
    }
    matrix->SetElement(axis, 3, matrix->GetElement(axis, 3) + offsets[axis]);
  }
}

// From the volume's texture coordinates to indices of the mask.
void FindIndices(vtkImageData* mask, vtkImageData* standIn, vtkMatrix4x4* matrix)
{
  int dimensions[3];
  standIn->GetDimensions(dimensions);
  const double cells[3] = { dimensions[0] - 1.0, dimensions[1] - 1.0, dimensions[2] - 1.0 };
  const double none[3] = { 0, 0, 0 };
  ScaleRows(matrix, cells, none);
  vtkMatrix4x4::Multiply4x4(standIn->GetIndexToPhysicalMatrix(), matrix, matrix);
  vtkMatrix4x4::Multiply4x4(mask->GetPhysicalToIndexMatrix(), matrix, matrix);
}

// From indices of a Cartesian mask to its texture coordinates.
void FindTexture(vtkImageData* mask, vtkMatrix4x4* matrix)
{
  int extent[6];
  mask->GetExtent(extent);
  const bool points = mask->GetPointData()->GetScalars() != nullptr;
  double factors[3];
  double offsets[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = extent[2 * axis + 1] - extent[2 * axis];
    factors[axis] = 1.0 / (points ? cells + 1 : cells);
    offsets[axis] = ((points ? 0.5 : 0.0) - extent[2 * axis]) * factors[axis];
  }
  ScaleRows(matrix, factors, offsets);
}
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMask::IsUsed(vtkGPUVolumeRayCastMapper* mapper, int components)
{
  const bool labels = mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType;
  return mapper->GetMaskInput() &&
    (!labels || (components == 1 && mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND));
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMask::Check(
  vtkGPUVolumeRayCastMapper* mapper, vtkVolumeProperty* property, int components, std::string& why)
{
  if (mapper->GetMaskInput() && property->GetIndependentComponents() && components > 1 &&
    mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::LabelMapMaskType &&
    mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND)
  {
    why = "The mask is a label map and the input's scalars have " + std::to_string(components) +
      " independent components; labels are for scalars of one.";
  }
  return why.empty();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMask::NoticeFunctions(vtkVolumeProperty* property)
{
  vtkMTimeType time = 0;
  for (const int label : property->GetLabelMapLabels())
  {
    for (vtkObject* function : std::initializer_list<vtkObject*>{ property->GetLabelColor(label),
           property->GetLabelScalarOpacity(label), property->GetLabelGradientOpacity(label) })
    {
      time = std::max(time, function ? function->GetMTime() : 0);
    }
  }
  if (time > property->GetMTime())
  {
    property->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMask::IsLattice(vtkImageData* mask, const vtkBCCVolumeFrame& held)
{
  return HasCountsOf(mask, held) ||
    (vtkBCCLattice::IsBCC(mask) && mask->GetPointData()->GetScalars());
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMask::SetUniforms(vtkShaderProgram* program, vtkImageData* mask,
  const vtkBCCVolumeFrame& volume, const vtkBCCVolumeFrame& held, vtkImageData* standIn)
{
  vtkNew<vtkMatrix4x4> matrix;
  if (IsLattice(mask, held))
  {
    const bool tagged = vtkBCCLattice::IsBCC(mask);
    const vtkBCCVolumeFrame frame = tagged ? vtkBCCVolumeFrame(mask) : held;
    double factors[3];
    double offsets[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      factors[axis] = tagged ? (axis == 2 ? 1.0 : 2.0) : volume.High[axis] - volume.Low[axis];
      offsets[axis] =
        tagged ? frame.Low[axis] - factors[axis] * frame.Extent[2 * axis] : volume.Low[axis];
    }
    if (tagged)
    {
      FindIndices(mask, standIn, matrix);
    }
    ScaleRows(matrix, factors, offsets);
    program->SetUniform3f("in_bccMaskLow", frame.Low);
    program->SetUniform3f("in_bccMaskHigh", frame.High);
    program->SetUniform3f("in_bccMaskPerUnit", frame.LatticePerUnit);
  }
  else
  {
    FindIndices(mask, standIn, matrix);
    FindTexture(mask, matrix);
  }
  // A lattice unit of the volume, in the mask's system.
  float margin[3] = { 0.0f, 0.0f, 0.0f };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int column = 0; column < 3; ++column)
    {
      margin[axis] += static_cast<float>(
        std::abs(matrix->GetElement(axis, column)) / (volume.High[column] - volume.Low[column]));
    }
  }
  program->SetUniform3f("in_bccMaskMargin", margin);
  matrix->Transpose(); // to columns
  program->SetUniformMatrix("in_bccMaskMatrix", matrix);
  program->SetUniformf("in_bccLabelFactor", vtkBCCMaskLabels::GetFactor(mask));
}
