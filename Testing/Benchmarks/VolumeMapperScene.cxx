// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeMapperScene.h"

#include "vtkBCCLattice.h"
#include "vtkBCCVolumeMapper.h"
#include "vtkBCCVolumeSource.h"
#include "vtkImageToBCCVolume.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
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

using Function = std::function<double(const double[3])>;

double MarschnerLobb(const double x[3])
{
  const double pi = std::acos(-1.0);
  const double rho = std::cos(12.0 * pi * std::cos(0.5 * pi * std::hypot(x[0], x[1])));
  return (1.0 - std::sin(0.5 * pi * x[2]) + 0.25 * (1.0 + rho)) / 2.5;
}

/// Skin at -100, brain about 40, bone about 1000 in air of -1000, on -1 .. 1 cubed.
double Head(const double x[3])
{
  const auto ellipsoid = [&](double a, double b, double c)
  {
    const double d[3] = { x[0] / a, x[1] / b, x[2] / c };
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - 1.0;
  };
  const auto inside = [](double distance) { return 0.5 - 0.5 * std::tanh(60.0 * distance); };
  const double skin = inside(ellipsoid(0.72, 0.9, 0.85));
  const double bone = inside(ellipsoid(0.65, 0.82, 0.78)) - inside(ellipsoid(0.58, 0.75, 0.71));
  const double folds = 20.0 * std::sin(20.0 * x[0]) * std::sin(17.0 * x[1]) * std::sin(23.0 * x[2]);
  return -1000.0 + 1040.0 * skin + 1000.0 * bone + folds * skin;
}

void Fill(vtkImageData* image, bool bcc, const Function& function)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Scalars");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  const int* size = image->GetDimensions();
  vtkSMPTools::For(0, size[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int k = static_cast<int>(begin); k < end; ++k)
      {
        const double* origin = image->GetOrigin();
        const double* h = image->GetSpacing();
        const double shift = bcc ? 0.5 * (k & 1) : 0.0;
        vtkIdType id = static_cast<vtkIdType>(k) * size[0] * size[1];
        for (int j = 0; j < size[1]; ++j)
        {
          for (int i = 0; i < size[0]; ++i, ++id)
          {
            const double x[3] = { origin[0] + h[0] * (i + shift), origin[1] + h[1] * (j + shift),
              origin[2] + h[2] * k };
            values->SetValue(id, static_cast<float>(function(x)));
          }
        }
      }
    });
  image->GetPointData()->SetScalars(values);
}

/// A function on -1 .. 1 cubed, on both lattices.
void MakePair(VolumePair& pair, const int dimensions[3], const Function& function)
{
  pair.BCC = vtkSmartPointer<vtkImageData>::New();
  pair.BCC->SetDimensions(dimensions);
  pair.BCC->SetOrigin(-1, -1, -1);
  pair.BCC->SetSpacing(
    2.0 / (dimensions[0] - 0.5), 2.0 / (dimensions[1] - 0.5), 2.0 / (dimensions[2] - 1));
  vtkBCCLattice::Tag(pair.BCC);
  Fill(pair.BCC, true, function);
  // As many points, in the same proportions but for the two cosets' layers.
  const double scale = std::cbrt(2.0);
  int size[3];
  for (int a = 0; a < 3; ++a)
  {
    size[a] =
      std::max(2, static_cast<int>(std::lround(dimensions[a] * (a == 2 ? 0.5 * scale : scale))));
  }
  pair.Cartesian = vtkSmartPointer<vtkImageData>::New();
  pair.Cartesian->SetDimensions(size);
  pair.Cartesian->SetOrigin(-1, -1, -1);
  pair.Cartesian->SetSpacing(2.0 / (size[0] - 1), 2.0 / (size[1] - 1), 2.0 / (size[2] - 1));
  Fill(pair.Cartesian, false, function);
}

void SetHeadOpacities(VolumePair& pair)
{
  pair.Opacities = { { -1000, 0 }, { -300, 0 }, { -100, 0.05 }, { 100, 0.1 }, { 300, 0.05 },
    { 1000, 0.8 } };
}

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
VolumePair MakeMarschnerLobb(int n, int width, int height)
{
  VolumePair pair;
  pair.Name = "ML " + std::to_string(n);
  pair.IsoValue = 0.5;
  pair.Opacities = { { 0, 0 }, { 0.45, 0 }, { 0.5, 0.5 }, { 0.55, 0 }, { 1, 0 } };
  pair.Width = width;
  pair.Height = height;
  const int dimensions[3] = { n, n, 2 * n };
  MakePair(pair, dimensions, MarschnerLobb);
  return pair;
}

//------------------------------------------------------------------------------
VolumePair MakeHead(const std::string& name, const int dimensions[3], int width, int height)
{
  VolumePair pair;
  pair.Name = name;
  pair.IsoValue = 300.0;
  pair.Width = width;
  pair.Height = height;
  SetHeadOpacities(pair);
  MakePair(pair, dimensions, Head);
  return pair;
}

//------------------------------------------------------------------------------
VolumePair ReadPair(const std::string& path, double isoValue, int width, int height)
{
  VolumePair pair;
  pair.Name = path.substr(path.find_last_of('/') + 1);
  pair.IsoValue = isoValue;
  pair.Width = width;
  pair.Height = height;
  SetHeadOpacities(pair);
  vtkNew<vtkMetaImageReader> reader;
  if (reader->CanReadFile(path.c_str()))
  {
    reader->SetFileName(path.c_str());
    vtkNew<vtkImageToBCCVolume> toBCC;
    toBCC->SetInputConnection(reader->GetOutputPort());
    toBCC->SetModeToResample();
    toBCC->Update();
    pair.BCC = toBCC->GetOutput();
    pair.Cartesian = reader->GetOutput();
  }
  return pair;
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
