// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCCoefficientArray.h"

#include "vtkBCCLattice.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkBCCCoefficientArray);

//------------------------------------------------------------------------------
bool vtkBCCCoefficientArray::Describe(vtkDataArray* samples, vtkImageData* image)
{
  const int components = samples->GetNumberOfComponents();
  this->SetNumberOfComponents(components);
  this->Ranges.resize(2 * components);
  bool finite = true;
  for (int component = 0; component < components; ++component)
  {
    double* range = this->Ranges.data() + 2 * component;
    if (!vtkBCCLattice::GetWholeRange(image, samples->GetName(), component, range))
    {
      samples->GetFiniteRange(range, component);
    }
    finite = finite && range[0] <= range[1];
  }
  this->Modified();
  return finite;
}

//------------------------------------------------------------------------------
bool vtkBCCCoefficientArray::ComputeScalarRange(double* ranges)
{
  std::copy(this->Ranges.begin(), this->Ranges.end(), ranges);
  return !this->Ranges.empty();
}

//------------------------------------------------------------------------------
bool vtkBCCCoefficientArray::ComputeFiniteScalarRange(double* ranges)
{
  return this->ComputeScalarRange(ranges);
}
