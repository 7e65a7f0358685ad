// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCChecks.h"

#include "ImageChecks.h"
#include "vtkBCCLattice.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace bravais
{

//------------------------------------------------------------------------------
bool CheckBCCImage(vtkImageData* image, const int whole[6], std::string& why)
{
  if (!image)
  {
    why = "There is no input image; a BCC volume was expected.";
    return false;
  }
  if (!vtkBCCLattice::IsBCC(image))
  {
    why = "The input is not tagged as a BCC volume: its field data need a string array Lattice "
          "that holds BCC.";
    return false;
  }
  const int* extent = whole ? whole : image->GetExtent();
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] >= extent[5])
  {
    why = "The input's dimensions are " + JoinDimensions(extent) +
      "; a BCC volume needs at least 1 x 1 x 2.";
    return false;
  }
  if (!CheckPlacement(image->GetOrigin(), image->GetSpacing(), why))
  {
    return false;
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() < 1 ||
    scalars->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    why = "The input has no point scalars, or fewer than points.";
    return false;
  }
  if (!IsNumberType(scalars->GetDataType()))
  {
    why = std::string("The input's scalars are of type ") + scalars->GetDataTypeAsString() +
      "; numbers of 8 to 64 bits were expected.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool CheckBCCImage(vtkImageData* image, std::string& why)
{
  return CheckBCCImage(image, nullptr, why);
}

} // namespace bravais
