// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeFrame.h"

#include "BCCLattice.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkBCCVolumeFrame::vtkBCCVolumeFrame(vtkImageData* volume)
  : vtkBCCVolumeFrame(volume, volume->GetExtent())
{
}

//------------------------------------------------------------------------------
vtkBCCVolumeFrame::vtkBCCVolumeFrame(vtkImageData* volume, const int extent[6])
{
  std::copy_n(extent, 6, this->Extent);
  const double* spacing = volume->GetSpacing();
  std::copy_n(volume->GetDirectionMatrix()->GetData(), 9, this->Direction);
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool layers = axis == 2;
    const int first = this->Extent[2 * axis];
    const int count = this->Extent[2 * axis + 1] - first + 1;
    const double length = layers ? count - 1 : count - 0.5; // in spacings
    this->Low[axis] = layers ? bravais::BCCLattice::GetCoset(first) : 0;
    this->High[axis] = this->Low[axis] + (layers ? length : 2 * length);
    this->LatticePerUnit[axis] = (layers ? 1 : 2) / spacing[axis];
    // As many cells as points along x and y, and as gaps between layers: for an isotropic lattice
    // the shortest edge of a cell is the distance of layers.
    this->Spacing[axis] = layers ? spacing[axis] : spacing[axis] * length / count;
  }
  volume->TransformContinuousIndexToPhysicalPoint(
    this->Extent[0], this->Extent[2], this->Extent[4], this->Origin);
}

//------------------------------------------------------------------------------
vtkIdType vtkBCCVolumeFrame::GetNumberOfPoints() const
{
  vtkIdType count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    count *= this->Extent[2 * axis + 1] - this->Extent[2 * axis] + 1;
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeFrame::GetGradientMatrix(float matrix[9]) const
{
  for (int i = 0; i < 9; ++i)
  {
    const int axis = i / 3;
    matrix[i] =
      static_cast<float>(this->Direction[3 * (i % 3) + axis] * this->LatticePerUnit[axis]);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeFrame::GetStandInExtent(int extent[6]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = 0;
    extent[2 * axis + 1] =
      this->Extent[2 * axis + 1] - this->Extent[2 * axis] + (axis == 2 ? 0 : 1);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeFrame::FitStandIn(vtkImageData* standIn, bool oneCell) const
{
  int extent[6];
  this->GetStandInExtent(extent);
  standIn->Initialize();
  standIn->SetOrigin(this->Origin);
  standIn->SetDirectionMatrix(const_cast<double*>(this->Direction));
  if (oneCell)
  {
    standIn->SetSpacing(
      this->Spacing[0] * extent[1], this->Spacing[1] * extent[3], this->Spacing[2] * extent[5]);
    standIn->SetDimensions(2, 2, 2);
  }
  else
  {
    standIn->SetSpacing(this->Spacing);
    standIn->SetExtent(extent);
  }
  standIn->Modified();
}
