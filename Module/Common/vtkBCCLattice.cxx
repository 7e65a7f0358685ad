// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCLattice.h"

#include "BCCLattice.h"
#include "BoxSpline.h"
#include "LatticeTag.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkBCCLattice);

namespace
{
bool CheckImage(vtkImageData* image, const char* helper)
{
  if (!image)
  {
    vtkErrorWithObjectMacro(nullptr, "vtkBCCLattice::" << helper << " expects an image, not none.");
  }
  return image != nullptr;
}
}

//------------------------------------------------------------------------------
void vtkBCCLattice::Tag(vtkImageData* image)
{
  if (!CheckImage(image, "Tag"))
  {
    return;
  }
  bravais::TagLattice(image, bravais::BCCTag);
}

//------------------------------------------------------------------------------
bool vtkBCCLattice::IsBCC(vtkDataObject* data)
{
  return bravais::HasLatticeTag(data, bravais::BCCTag);
}

//------------------------------------------------------------------------------
void vtkBCCLattice::GetPoint(vtkImageData* image, const int ijk[3], double x[3])
{
  if (!CheckImage(image, "GetPoint"))
  {
    return;
  }
  const double half = 0.5 * bravais::BCCLattice::GetCoset(ijk[2]);
  image->TransformContinuousIndexToPhysicalPoint(ijk[0] + half, ijk[1] + half, ijk[2], x);
}

//------------------------------------------------------------------------------
void vtkBCCLattice::GetBox(vtkImageData* image, double bounds[6])
{
  if (!CheckImage(image, "GetBox"))
  {
    return;
  }
  const int* extent = image->GetExtent();
  vtkBoundingBox box;
  if (extent[0] <= extent[1] && extent[2] <= extent[3] && extent[4] <= extent[5])
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      double x[3];
      image->TransformContinuousIndexToPhysicalPoint(corner & 1 ? extent[1] + 0.5 : extent[0],
        corner & 2 ? extent[3] + 0.5 : extent[2], corner & 4 ? extent[5] : extent[4], x);
      box.AddPoint(x);
    }
    box.GetBounds(bounds);
  }
  else
  {
    vtkMath::UninitializeBounds(bounds);
  }
}

//------------------------------------------------------------------------------
double vtkBCCLattice::Evaluate(int kernel, double x, double y, double z)
{
  const auto known = bravais::ToBCCKernel(kernel);
  if (!known)
  {
    vtkErrorWithObjectMacro(nullptr,
      "vtkBCCLattice::Evaluate expects the kernel BCC4, BCC7, BCC8 or BCC12, not " << kernel
                                                                                   << '.');
    return 0.0;
  }
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorWithObjectMacro(nullptr,
      "vtkBCCLattice::Evaluate expects finite coordinates, not (" << x << ", " << y << ", " << z
                                                                  << ").");
    return 0.0;
  }
  return bravais::EvaluateKernel(*known, { x, y, z });
}

//------------------------------------------------------------------------------
void vtkBCCLattice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
