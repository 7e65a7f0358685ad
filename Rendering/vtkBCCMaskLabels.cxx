// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCMaskLabels.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
vtkDataSetAttributes* GetHolder(vtkImageData* mask)
{
  vtkDataSetAttributes* points = mask->GetPointData();
  return points->GetScalars() ? points : mask->GetCellData();
}
}

vtkBCCMaskLabels::vtkBCCMaskLabels() = default;
vtkBCCMaskLabels::~vtkBCCMaskLabels() = default;

//------------------------------------------------------------------------------
vtkImageData* vtkBCCMaskLabels::GetLoadable(vtkImageData* mask)
{
  vtkDataArray* labels = mask ? GetHolder(mask)->GetScalars() : nullptr;
  const int type = labels ? labels->GetDataType() : VTK_FLOAT;
  if (type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT)
  {
    this->Copy = nullptr;
    return mask;
  }
  if (!this->Copy || this->Source != mask || this->Time != mask->GetMTime())
  {
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(labels);
    this->Copy = vtkSmartPointer<vtkImageData>::New();
    this->Copy->CopyStructure(mask);
    this->Copy->SetFieldData(mask->GetFieldData()); // with the tag of a lattice
    GetHolder(mask) == mask->GetPointData() ? this->Copy->GetPointData()->SetScalars(floats)
                                            : this->Copy->GetCellData()->SetScalars(floats);
    this->Source = mask;
    this->Time = mask->GetMTime();
  }
  return this->Copy;
}

//------------------------------------------------------------------------------
float vtkBCCMaskLabels::GetFactor(vtkImageData* mask)
{
  switch (GetHolder(mask)->GetScalars()->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return VTK_UNSIGNED_CHAR_MAX;
    case VTK_UNSIGNED_SHORT:
      return VTK_UNSIGNED_SHORT_MAX;
    default:
      return 1.0f;
  }
}
