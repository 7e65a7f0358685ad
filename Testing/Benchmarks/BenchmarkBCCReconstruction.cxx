// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast a BCC volume is evaluated on a Cartesian grid, beside VTK's reslice of a Cartesian
// volume with as many samples, on as many output points; how fast its prefilters are; how much
// memory they take. All threads are used by all.
//
//   BenchmarkBCCReconstruction [nx] [output points along each axis]

#include "RatioReporter.h"

#include "vtkBCCPrefilter.h"
#include "vtkBCCVolumeSource.h"
#include "vtkBCCVolumeToImage.h"

#include "vtkImageBSplineCoefficients.h"
#include "vtkImageBSplineInterpolator.h"
#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkImageReslice.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <malloc.h>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace
{

/// A Cartesian volume with noise-free values and about as many samples as the BCC one.
vtkSmartPointer<vtkImageData> MakeCartesian(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(2.0 / (n - 1), 2.0 / (n - 1), 2.0 / (n - 1));
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  float* value = static_cast<float*>(image->GetScalarPointer());
  for (int k = 0; k < n * n * n; ++k)
  {
    value[k] = static_cast<float>(std::sin(0.001 * k));
  }
  return image;
}

/// Reslices on the grid of the others, or on one turned about all axes.
void AddReslice(const std::string& name, vtkImageData* input,
  vtkAbstractImageInterpolator* interpolator, int n, bool turned)
{
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(input);
  reslice->SetInterpolator(interpolator);
  if (auto* standard = vtkImageInterpolator::SafeDownCast(interpolator))
  {
    // The filter sets this interpolator's mode to its own.
    reslice->SetInterpolationMode(standard->GetInterpolationMode());
  }
  reslice->SetOutputExtent(0, n - 1, 0, n - 1, 0, n - 1);
  reslice->SetOutputSpacing(2.0 / (n - 1), 2.0 / (n - 1), 2.0 / (n - 1));
  reslice->SetOutputOrigin(-1.0, -1.0, -1.0);
  if (turned)
  {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(20.0, 1.0, 2.0, 3.0);
    reslice->SetResliceTransform(transform);
  }
  vtkSmartPointer<vtkImageReslice> filter = reslice;
  bravais::AddBenchmark(name + (turned ? ", turned" : ""), std::pow(n, 3),
    [=]
    {
      filter->Modified();
      filter->Update();
    });
}

vtkSmartPointer<vtkBCCVolumeToImage> MakeSampler(vtkImageData* volume, int kernel, int n)
{
  auto sampler = vtkSmartPointer<vtkBCCVolumeToImage>::New();
  sampler->SetInputData(volume);
  sampler->SetKernel(kernel);
  sampler->SetOutputDimensions(n, n, n);
  return sampler;
}

vtkSmartPointer<vtkBCCPrefilter> MakePrefilter(vtkImageData* volume, int kernel, int method)
{
  auto filter = vtkSmartPointer<vtkBCCPrefilter>::New();
  filter->SetInputData(volume);
  filter->SetKernel(kernel);
  filter->SetMethod(method);
  return filter;
}

void PrintMemory(const char* name, vtkAlgorithm* filter, double input)
{
  malloc_trim(0); // so that memory given back is counted when it is taken again
  const double peak = bravais::MeasurePeakMemory([=] { filter->Update(); });
  const double output = filter->GetOutputDataObject(0)->GetActualMemorySize() / 1024.0;
  std::printf("%-44s %10.1f %10.1f %10.1f %10.2f\n", name, input, output, peak,
    (input + peak) / (input + output));
  filter->GetOutputDataObject(0)->Initialize();
}

} // namespace

int main(int argc, char* argv[])
{
  const int nx = argc > 1 ? std::atoi(argv[1]) : 89;
  const int n = argc > 2 ? std::atoi(argv[2]) : 176;
  if (nx < 2 || n < 2)
  {
    std::fprintf(stderr, "usage: %s [nx >= 2] [output points along each axis >= 2]\n", argv[0]);
    return 1;
  }
  vtkNew<vtkBCCVolumeSource> source;
  source->SetDimensions(nx, nx, 2 * nx);
  source->Update();
  vtkSmartPointer<vtkImageData> volume = source->GetOutput();
  const int cartesian = static_cast<int>(std::lround(std::cbrt(2.0 * std::pow(nx, 3))));
  vtkSmartPointer<vtkImageData> image = MakeCartesian(cartesian);
  std::printf("%d x %d x %d BCC samples, %d^3 Cartesian ones (float), %d^3 output points\n\n", nx,
    nx, 2 * nx, cartesian, n);

  benchmark::Initialize(&argc, argv);
  vtkNew<vtkImageBSplineCoefficients> coefficients;
  coefficients->SetInputData(image);
  coefficients->Update();
  for (const bool turned : { false, true })
  {
    vtkNew<vtkImageInterpolator> linear;
    linear->SetInterpolationModeToLinear();
    AddReslice("VTK linear", image, linear, n, turned);
    vtkNew<vtkImageInterpolator> cubic;
    cubic->SetInterpolationModeToCubic();
    AddReslice("VTK Catmull-Rom", image, cubic, n, turned);
    vtkNew<vtkImageBSplineInterpolator> spline;
    spline->SetSplineDegree(3);
    AddReslice("VTK cubic B-spline", coefficients->GetOutput(), spline, n, turned);
  }
  for (const int kernel : { 4, 7, 8, 12 })
  {
    for (const bool gradients : { false, true })
    {
      vtkSmartPointer<vtkBCCVolumeToImage> sampler = MakeSampler(volume, kernel, n);
      sampler->SetComputeGradients(gradients);
      bravais::AddBenchmark(
        std::string(sampler->GetKernelAsString()) + (gradients ? " with gradients" : ""),
        std::pow(n, 3),
        [=]
        {
          sampler->Modified();
          sampler->Update();
        });
    }
  }
  bravais::RatioReporter points(
    "Mpoints/s", { "VTK linear", "VTK cubic B-spline", "VTK cubic B-spline, turned" });
  benchmark::RunSpecifiedBenchmarks(&points);

  std::printf("\n");
  benchmark::ClearRegisteredBenchmarks();
  bravais::AddBenchmark("VTK B-spline coefficients", std::pow(cartesian, 3),
    [&]
    {
      coefficients->Modified();
      coefficients->Update();
    });
  for (const auto& [kernel, method] :
    { std::pair{ 7, 1 }, { 12, 1 }, { 8, 2 }, { 7, 3 }, { 8, 3 }, { 12, 3 } })
  {
    vtkSmartPointer<vtkBCCPrefilter> filter = MakePrefilter(volume, kernel, method);
    bravais::AddBenchmark(
      std::string(filter->GetKernelAsString()) + " " + filter->GetMethodAsString(),
      2.0 * std::pow(nx, 3),
      [=]
      {
        filter->Modified();
        filter->Update();
      });
  }
  bravais::RatioReporter samples("Msamples/s", { "VTK B-spline coefficients" });
  benchmark::RunSpecifiedBenchmarks(&samples);

  const double input = volume->GetActualMemorySize() / 1024.0;
  std::printf(
    "\n%-44s %10s %10s %10s %10s\n", "memory, MiB", "input", "output", "growth", "peak / in+out");
  PrintMemory("BCC7 on the grid", MakeSampler(volume, 7, n), input);
  PrintMemory("BCC7 QuasiInterpolation", MakePrefilter(volume, 7, 1), input);
  PrintMemory("BCC7 Projection", MakePrefilter(volume, 7, 3), input);
  return 0;
}
