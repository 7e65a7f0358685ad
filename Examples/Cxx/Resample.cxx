// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Resample.h"

#include "vtkBCCLattice.h"
#include "vtkImageData.h"
#include "vtkImageReslice.h"
#include "vtkImageSincInterpolator.h"
#include "vtkImageToBCCVolume.h"
#include "vtkNew.h"

#include <cmath>

namespace
{

/// Points along an axis of some length, of spacing h.
int CountPoints(double length, double h)
{
  return static_cast<int>(std::floor(length / h)) + 1;
}

/// The spacing at which an isotropic grid has at most that many points in a box.
double FindSpacing(const double length[3], double samples)
{
  double low = 0.0;
  double high = length[0] + length[1] + length[2];
  for (int step = 0; step < 60; ++step)
  {
    const double h = 0.5 * (low + high);
    const double points = std::floor(length[0] / h + 1.0) * std::floor(length[1] / h + 1.0) *
      std::floor(length[2] / h + 1.0);
    (points > samples ? low : high) = h;
  }
  return high;
}

} // namespace

vtkSmartPointer<vtkImageData> ResampleToBCC(vtkImageData* image, double ratio)
{
  if (vtkBCCLattice::IsBCC(image))
  {
    return image;
  }
  vtkNew<vtkImageToBCCVolume> toBCC;
  toBCC->SetInputData(image);
  toBCC->SetSampleRatio(ratio);
  toBCC->Update();
  vtkImageData* volume = toBCC->GetOutput();
  return volume->GetNumberOfPoints() > 0 ? volume : nullptr;
}

vtkSmartPointer<vtkImageData> ResampleToCartesian(vtkImageData* image, vtkIdType samples)
{
  double bounds[6];
  image->GetBounds(bounds);
  const double length[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  const double h = FindSpacing(length, static_cast<double>(samples));
  int extent[6] = { 0, 0, 0, 0, 0, 0 };
  double origin[3];
  for (int a = 0; a < 3; ++a)
  {
    extent[2 * a + 1] = CountPoints(length[a], h) - 1;
    origin[a] = 0.5 * (bounds[2 * a] + bounds[2 * a + 1] - h * extent[2 * a + 1]);
  }

  vtkNew<vtkImageSincInterpolator> sinc;
  sinc->SetWindowFunctionToKaiser();
  sinc->SetWindowHalfWidth(6);
  sinc->AntialiasingOn();
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(image);
  reslice->SetInterpolator(sinc);
  reslice->SetOutputSpacing(h, h, h);
  reslice->SetOutputOrigin(origin);
  reslice->SetOutputExtent(extent);
  reslice->MirrorOn();
  reslice->Update();
  return reslice->GetOutput();
}
