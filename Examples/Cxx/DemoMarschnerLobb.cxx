// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DemoMarschnerLobb.h"

#include "CommandLine.h"
#include "Gallery.h"

#include "vtkBCCInterpolator.h"
#include "vtkBCCVolumeSource.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <cmath>
#include <random>

namespace
{

/// What vtkBCCVolumeSource samples, with its default parameters.
double MarschnerLobb(const double x[3])
{
  const double alpha = 0.25;
  const double frequency = 6.0;
  const double pi = vtkMath::Pi();
  const double r = std::hypot(x[0], x[1]);
  const double ripple = std::cos(2.0 * pi * frequency * std::cos(0.5 * pi * r));
  return (1.0 - std::sin(0.5 * pi * x[2]) + alpha * (1.0 + ripple)) / (2.0 * (1.0 + alpha));
}

vtkSmartPointer<vtkImageData> MakeBCC(int nx, int ny, int nk)
{
  vtkNew<vtkBCCVolumeSource> source;
  source->SetDimensions(nx, ny, nk);
  source->Update();
  return source->GetOutput();
}

/// n^3 samples on the cube from -1 to 1.
vtkSmartPointer<vtkImageData> MakeCartesian(int n)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  const double h = 2.0 / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(h, h, h);
  vtkNew<vtkFloatArray> values;
  values->SetName("Scalars");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    values->SetValue(id, static_cast<float>(MarschnerLobb(image->GetPoint(id))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Root mean square error at random points of the cube from -0.6 to 0.6, the same each time.
double MeasureError(vtkAbstractImageInterpolator* interpolator, vtkImageData* volume)
{
  const int count = 100000;
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> coordinate(-0.6, 0.6);
  interpolator->Initialize(volume);
  interpolator->Update();
  double sum = 0.0;
  for (int p = 0; p < count; ++p)
  {
    double x[3];
    for (double& value : x)
    {
      value = coordinate(generator);
    }
    double found = 0.0;
    interpolator->Interpolate(x, &found);
    sum += (found - MarschnerLobb(x)) * (found - MarschnerLobb(x));
  }
  interpolator->ReleaseData();
  return std::sqrt(sum / count);
}

double MeasureBCCError(vtkImageData* volume, int kernel, int prefilter)
{
  vtkNew<vtkBCCInterpolator> interpolator;
  interpolator->SetKernel(kernel);
  interpolator->SetPrefilter(prefilter);
  return MeasureError(interpolator, volume);
}

} // namespace

bool DrawMarschnerLobb(Gallery& gallery, std::string& why)
{
  const auto coarse = MakeBCC(39, 39, 78);
  const auto cartesian = MakeCartesian(49);
  const auto fine = MakeBCC(78, 78, 156);

  Drawing drawing;
  drawing.Surfaces = { { 0.5, { 0.86, 0.62, 0.30 }, 1.0 } };
  drawing.Look.From[0] = 0.35;
  drawing.Look.From[1] = -0.75;
  drawing.Look.From[2] = 1.0;
  drawing.Look.Zoom = 1.25;
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  const auto draw = [&](const std::string& name, vtkImageData* volume)
  {
    drawing.Name = "marschner-lobb-" + name;
    drawing.Volume = volume;
    pictures.push_back(gallery.Draw(drawing, why));
    return pictures.back() != nullptr;
  };
  for (int prefilter : { 1, 3 })
  {
    drawing.Prefilter = prefilter;
    for (int kernel : { 12, 8, 7 })
    {
      drawing.Kernel = kernel;
      drawing.Error = MeasureBCCError(coarse, kernel, prefilter);
      if (!draw(NameOfKernel(kernel) + (prefilter == 3 ? "-projection" : ""), coarse))
      {
        return false;
      }
    }
    if (prefilter == 1)
    {
      vtkNew<vtkImageInterpolator> linear;
      drawing.Error = MeasureError(linear, cartesian);
    }
    else
    {
      drawing.Kernel = 12;
      drawing.Error = MeasureBCCError(fine, 12, prefilter);
      drawing.Label = "8 times as many samples";
    }
    if (!(prefilter == 1 ? draw("trilinear", cartesian) : draw("fine", fine)))
    {
      return false;
    }
  }
  return gallery.WriteMontage("marschner-lobb", pictures, 4, 2, why);
}
