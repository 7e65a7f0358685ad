// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeMapperScene.h"

#include "vtkBCCVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>

namespace bravais
{
namespace
{

double GetSeconds(bool clock)
{
  return clock
    ? std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()
    : static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeMapper(
  const VolumePair& pair, const MapperChoice& choice, RenderMode mode)
{
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper;
  if (choice.Kernel == 0)
  {
    mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    mapper->SetInputData(pair.Cartesian);
  }
  else
  {
    auto ours = vtkSmartPointer<vtkBCCVolumeMapper>::New();
    ours->SetKernel(choice.Kernel);
    ours->SetEmptySpaceSkipping(choice.Skip);
    ours->SetInputData(pair.BCC);
    mapper = ours;
  }
  mapper->AutoAdjustSampleDistancesOff();
  const double* b = pair.Cartesian->GetBounds();
  mapper->SetSampleDistance(static_cast<float>(0.5 *
    std::cbrt((b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]) /
      static_cast<double>(pair.Cartesian->GetNumberOfPoints()))));
  mapper->SetBlendMode(mode == RenderMode::IsoSurface ? vtkVolumeMapper::ISOSURFACE_BLEND
      : mode == RenderMode::Maximum                   ? vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND
                                                      : vtkVolumeMapper::COMPOSITE_BLEND);
  return mapper;
}

void SetProperty(vtkVolumeProperty* property, const VolumePair& pair, RenderMode mode)
{
  double range[2];
  pair.Cartesian->GetScalarRange(range);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(range[0], 0.3, 0.2, 0.1);
  colors->AddRGBPoint(range[1], 1.0, 0.95, 0.9);
  vtkNew<vtkPiecewiseFunction> opacity;
  if (mode == RenderMode::IsoSurface)
  {
    opacity->AddPoint(range[0], 1.0);
    opacity->AddPoint(range[1], 1.0);
    property->GetIsoSurfaceValues()->SetValue(0, pair.IsoValue);
  }
  else if (mode == RenderMode::Maximum)
  {
    opacity->AddPoint(range[0], 0.0);
    opacity->AddPoint(range[1], 1.0);
  }
  else
  {
    for (const auto& point : pair.Opacities)
    {
      opacity->AddPoint(point.first, point.second);
    }
  }
  const double* b = pair.Cartesian->GetBounds();
  property->SetScalarOpacityUnitDistance((b[1] - b[0]) / 100.0);
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
  property->SetShade(mode == RenderMode::IsoSurface || mode == RenderMode::Shaded);
}

/// A window with one volume.
class Scene
{
public:
  Scene(const VolumePair& pair, const MapperChoice& choice, RenderMode mode)
    : Mapper(MakeMapper(pair, choice, mode))
  {
    vtkNew<vtkRenderer> renderer;
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(pair.Width, pair.Height);
    this->Window->AddRenderer(renderer);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(this->Mapper);
    SetProperty(volume->GetProperty(), pair, mode);
    renderer->AddVolume(volume);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.55, -1.0, 0.35);
    camera->SetViewUp(0, 0, 1);
    renderer->ResetCamera(pair.Cartesian->GetBounds());
    camera->Zoom(1.4);
  }

  /// Seconds that a frame takes.
  double Draw(bool clock)
  {
    const double before = GetSeconds(clock);
    this->Window->Render();
    this->Window->WaitForCompletion();
    return GetSeconds(clock) - before;
  }

  /// The least of two frames after a change of the data.
  double DrawChanged(bool clock)
  {
    double least = std::numeric_limits<double>::max();
    for (int n = 0; n < 2; ++n)
    {
      auto* image = vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
      image->GetPointData()->GetScalars()->Modified();
      image->Modified();
      least = std::min(least, this->Draw(clock));
    }
    return least;
  }

  double GetMemory(bool bricks)
  {
    if (auto* ours = vtkBCCVolumeMapper::SafeDownCast(this->Mapper))
    {
      return static_cast<double>(
        ours->GetCoefficientMemory() + (bricks ? ours->GetBrickMemory() : 0));
    }
    auto* image = vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
    return static_cast<double>(image->GetNumberOfPoints() * image->GetScalarSize());
  }

private:
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkRenderWindow> Window;
};

} // namespace

//------------------------------------------------------------------------------
const char* GetName(RenderMode mode)
{
  switch (mode)
  {
    case RenderMode::IsoSurface:
      return "isosurface";
    case RenderMode::Composite:
      return "composite";
    case RenderMode::Shaded:
      return "composite, shaded";
    case RenderMode::Maximum:
      break;
  }
  return "maximum intensity";
}

//------------------------------------------------------------------------------
double FrameTimes::GetRatio(const FrameTimes& peer) const
{
  std::vector<double> ratios(this->Frames.size());
  std::transform(this->Frames.begin(), this->Frames.end(), peer.Frames.begin(), ratios.begin(),
    std::divides<>());
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

//------------------------------------------------------------------------------
std::vector<FrameTimes> TimeFrames(const VolumePair& pair, const std::vector<MapperChoice>& choices,
  RenderMode mode, int frames, bool clock)
{
  std::vector<std::unique_ptr<Scene>> scenes;
  for (const MapperChoice& choice : choices)
  {
    scenes.push_back(std::make_unique<Scene>(pair, choice, mode));
    scenes.back()->Draw(clock); // compiles the shaders
  }
  std::vector<FrameTimes> times(choices.size());
  for (int n = 0; n < frames; ++n)
  {
    for (std::size_t i = 0; i < scenes.size(); ++i)
    {
      times[i].Frames.push_back(scenes[i]->Draw(clock));
    }
  }
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    times[i].Fastest = *std::min_element(times[i].Frames.begin(), times[i].Frames.end());
    times[i].First = scenes[i]->DrawChanged(clock);
    times[i].Memory = scenes[i]->GetMemory(choices[i].Skip);
  }
  return times;
}

} // namespace bravais
