// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LatticeTag.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace bravais
{

//------------------------------------------------------------------------------
void TagLattice(vtkImageData* image, const char* tag)
{
  vtkNew<vtkStringArray> array;
  array->SetName("Lattice");
  array->InsertNextValue(tag);
  image->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
bool HasLatticeTag(vtkDataObject* data, const char* tag)
{
  auto* image = vtkImageData::SafeDownCast(data);
  auto* array = image
    ? vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("Lattice"))
    : nullptr;
  return array && array->GetNumberOfValues() == 1 && array->GetValue(0) == tag;
}

} // namespace bravais
