// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// No filter holds more than its input, its output and a tenth of both. Interpolation and Projection
// of vtkBCCVolumeToImage hold the coefficients too, and a tenth of these.

#include "AllocationCounter.h"

#include "vtkBCCPrefilter.h"
#include "vtkBCCVolumeSource.h"
#include "vtkBCCVolumeToImage.h"

#include "vtkDataArray.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageCast.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <iostream>

namespace
{

bool Passed = true;

vtkSmartPointer<vtkImageData> MakeVolume(int type, int components)
{
  vtkNew<vtkBCCVolumeSource> source;
  source->SetDimensions(40, 40, 220);
  vtkNew<vtkImageCast> cast;
  cast->SetInputConnection(source->GetOutputPort());
  cast->SetOutputScalarType(type);
  vtkNew<vtkImageAppendComponents> append;
  for (int c = 0; c < components; ++c)
  {
    append->AddInputConnection(cast->GetOutputPort());
  }
  append->Update();
  return append->GetOutput();
}

double CountBytes(vtkImageData* image)
{
  double bytes = 0.0;
  for (int n = 0; n < image->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(n);
    bytes += static_cast<double>(array->GetNumberOfValues()) * array->GetDataTypeSize();
  }
  return bytes;
}

/// Runs a filter, and compares the bytes it needed beyond its output with what it may need.
void Check(const char* what, vtkImageAlgorithm* filter, vtkImageData* volume, double more = 0.0)
{
  const double before = static_cast<double>(GetAllocatedBytes());
  ResetAllocationPeak();
  filter->SetInputData(volume);
  filter->Update();
  const double peak = static_cast<double>(GetAllocationPeak()) - before;
  const double after = static_cast<double>(GetAllocatedBytes()) - before;
  const double input = CountBytes(volume);
  const double output = CountBytes(filter->GetOutput());
  const double pipeline = 64.0 * 1024.0; // the algorithms and their informations
  const double limit = output + 0.1 * (input + output) + more + pipeline;
  std::cout << what << ", " << volume->GetScalarTypeAsString() << ", "
            << volume->GetNumberOfScalarComponents() << " components: input " << input
            << " bytes, output " << output << ", " << (peak - output) / (input + output) * 100.0
            << " % of both besides\n";
  if (output == 0.0 || peak > limit || peak < output || after > output + pipeline)
  {
    std::cerr << "The peak is " << peak << " bytes and the rest " << after << "; up to " << limit
              << " and " << output + pipeline << " were expected.\n";
    Passed = false;
  }
}

void CheckVolumeToImage(vtkImageData* volume, int prefilter, bool gradients, double more = 0.0)
{
  vtkNew<vtkBCCVolumeToImage> filter;
  filter->SetOutputDimensions(60, 60, 220);
  filter->SetPrefilter(prefilter);
  filter->SetKernelToBCC8();
  filter->SetComputeGradients(gradients);
  Check(
    gradients ? "vtkBCCVolumeToImage with gradients" : "vtkBCCVolumeToImage", filter, volume, more);
}

} // namespace

int TestBCCFilterMemory(int, char*[])
{
  vtkSMPTools::Initialize(2);
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    for (const int components : { 1, 3 })
    {
      const auto volume = MakeVolume(type, components);
      for (const int method : { vtkBCCPrefilter::None, vtkBCCPrefilter::QuasiInterpolation,
             vtkBCCPrefilter::Interpolation, vtkBCCPrefilter::Projection })
      {
        vtkNew<vtkBCCPrefilter> filter;
        filter->SetMethod(method);
        filter->SetKernelToBCC8();
        Check("vtkBCCPrefilter", filter, volume);
      }
      CheckVolumeToImage(volume, 0, false);
      CheckVolumeToImage(volume, 1, false);
      CheckVolumeToImage(volume, 1, true);
      const double coefficients = static_cast<double>(volume->GetNumberOfPoints()) * components *
        (type == VTK_DOUBLE ? sizeof(double) : sizeof(float));
      CheckVolumeToImage(volume, 2, false, 1.1 * coefficients);
    }
  }
  return Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
