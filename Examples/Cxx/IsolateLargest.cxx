// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolateLargest.h"

#include "vtkDataArray.h"
#include "vtkImageConnectivityFilter.h"
#include "vtkImageData.h"
#include "vtkImageDilateErode3D.h"
#include "vtkImageMask.h"
#include "vtkNew.h"
#include "vtkPointData.h"

vtkSmartPointer<vtkImageData> IsolateLargest(vtkImageData* image, double threshold)
{
  double range[2];
  image->GetScalarRange(range);
  vtkNew<vtkImageConnectivityFilter> regions;
  regions->SetInputData(image);
  regions->SetScalarRange(threshold, range[1]);
  regions->SetExtractionModeToLargestRegion();
  regions->SetLabelModeToConstantValue();
  regions->SetLabelConstantValue(1);
  regions->SetLabelScalarTypeToUnsignedChar();
  vtkNew<vtkImageDilateErode3D> region;
  region->SetInputConnection(regions->GetOutputPort());
  region->SetDilateValue(1);
  region->SetErodeValue(0);
  region->SetKernelSize(5, 5, 5);
  vtkNew<vtkImageMask> mask;
  mask->SetInputData(0, image);
  mask->SetInputConnection(1, region->GetOutputPort());
  mask->SetMaskedOutputValue(range[0]);
  mask->Update();
  vtkImageData* isolated = mask->GetOutput();
  return isolated->GetNumberOfPoints() > 0 ? isolated : nullptr;
}
