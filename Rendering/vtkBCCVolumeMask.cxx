// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeMask.h"

#include "vtkBCCLattice.h"
#include "vtkBCCVolumeFrame.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

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
  matrix->Transpose(); // to columns
  program->SetUniformMatrix("in_bccMaskMatrix", matrix);
}
