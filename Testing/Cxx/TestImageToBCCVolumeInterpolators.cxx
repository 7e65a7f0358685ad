// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
// An interpolator that has no rows, as VTK's all have, is asked point by point; one with rows gives
// what its own points give. Neither is modified.

#include "vtkBCCLattice.h"
#include "vtkImageToBCCVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkImageSincInterpolator.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstdlib>

namespace
{

/// A vtkImageInterpolator that says it has no rows.
class PointInterpolator : public vtkImageInterpolator
{
public:
  static PointInterpolator* New();
  vtkTypeMacro(PointInterpolator, vtkImageInterpolator);
  bool IsSeparable() override { return false; }
};
vtkStandardNewMacro(PointInterpolator);

/// The largest difference between the output and the interpolator at the output's points.
double Compare(vtkImageData* input, vtkAbstractImageInterpolator* interpolator)
{
  vtkNew<vtkImageToBCCVolume> toBCC;
  toBCC->SetInputData(input);
  toBCC->SetInterpolator(interpolator);
  const vtkMTimeType before = interpolator->GetMTime();
  toBCC->Update();
  if (interpolator->GetMTime() != before)
  {
    vtkLog(ERROR, "Interpolator was modified.");
    return VTK_DOUBLE_MAX;
  }
  vtkImageData* output = toBCC->GetOutput();
  interpolator->Initialize(input);
  interpolator->Update();
  double most = output->GetNumberOfPoints() > 1000 ? 0.0 : VTK_DOUBLE_MAX;
  int n[3];
  output->GetDimensions(n);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const int ijk[3] = { static_cast<int>(p % n[0]), static_cast<int>(p / n[0] % n[1]),
      static_cast<int>(p / n[0] / n[1]) };
    double x[3];
    double value;
    vtkBCCLattice::GetPoint(output, ijk, x);
    interpolator->Interpolate(x, &value);
    const double difference =
      std::abs(value - output->GetPointData()->GetScalars()->GetComponent(p, 0));
    most = std::max(most, difference);
  }
  interpolator->ReleaseData();
  return most;
}

}

int TestImageToBCCVolumeInterpolators(int, char*[])
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-6, 7, -5, 5, -8, 6);
  wavelet->Update();
  vtkImageData* input = wavelet->GetOutput();

  vtkNew<vtkImageInterpolator> linear;
  vtkNew<vtkImageInterpolator> cubic;
  cubic->SetInterpolationModeToCubic();
  vtkNew<vtkImageInterpolator> sliding;
  sliding->SetInterpolationModeToCubic();
  sliding->SlidingWindowOn();
  vtkNew<vtkImageSincInterpolator> sinc;
  vtkNew<PointInterpolator> points;
  points->SetInterpolationModeToCubic();
  int result = EXIT_SUCCESS;
  for (vtkAbstractImageInterpolator* interpolator :
    { static_cast<vtkAbstractImageInterpolator*>(linear),
      static_cast<vtkAbstractImageInterpolator*>(cubic),
      static_cast<vtkAbstractImageInterpolator*>(sliding),
      static_cast<vtkAbstractImageInterpolator*>(sinc),
      static_cast<vtkAbstractImageInterpolator*>(points) })
  {
    for (const int threads : { 1, 2 })
    {
      double most = VTK_DOUBLE_MAX;
      vtkSMPTools::LocalScope(
        vtkSMPTools::Config{ threads }, [&]() { most = Compare(input, interpolator); });
      if (!(most < 1e-2)) // of values up to 280; VTK rounds places to 2^-16 of a step
      {
        vtkLog(ERROR, << interpolator->GetClassName() << " differs by " << most);
        result = EXIT_FAILURE;
      }
    }
  }
  return result;
}
