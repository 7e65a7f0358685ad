// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCLattice.h"

#include "vtkImageData.h"
#include "vtkNew.h"

int main()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(39, 39, 78);
  vtkBCCLattice::Tag(image);
  double box[6];
  vtkBCCLattice::GetBox(image, box);
  return vtkBCCLattice::IsBCC(image) && box[1] == 38.5 && box[5] == 77.0 ? 0 : 1;
}
