// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// What a frame costs while the camera moves, beside a frame that is drawn at once: processor time,
// the least of several. What VTK's ray caster does for any frame, such as copying depths, is
// measured by a volume of less than a pixel. The column "pass x pixels", the cost of a pass without
// that times the pixels of a block, over a frame at once, should stay below 1.3. The last column
// has the same for a frame at once of a window of as many pixels as a pass traces.
//
//   BenchmarkProgressive [pixels along a side of the window]

#include "vtkBCCVolumeMapper.h"
#include "vtkBCCVolumeSource.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace
{

class Scene
{
public:
  Scene(int size, bool surface)
  {
    vtkNew<vtkBCCVolumeSource> source;
    this->Mapper->SetInputConnection(source->GetOutputPort());
    this->Mapper->SetAutoAdjustSampleDistances(false);
    this->Mapper->SetSampleDistance(0.02f);
    if (surface)
    {
      this->Mapper->SetBlendModeToIsoSurface();
    }
    vtkNew<vtkColorTransferFunction> colors;
    colors->AddRGBPoint(0.0, 0.2, 0.4, 1.0);
    colors->AddRGBPoint(1.0, 1.0, 0.5, 0.1);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, surface ? 1.0 : 0.0);
    opacity->AddPoint(1.0, surface ? 1.0 : 0.05);
    vtkVolumeProperty* look = this->Volume->GetProperty();
    look->SetColor(colors);
    look->SetScalarOpacity(opacity);
    look->SetShade(true);
    look->GetIsoSurfaceValues()->SetValue(0, 0.5);
    this->Volume->SetMapper(this->Mapper);
    this->Renderer->AddVolume(this->Volume);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.5, -3.0, 2.2);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    camera->Zoom(1.4);
  }

  /// Seconds of a frame after the camera has moved.
  double Time(int frames)
  {
    double best = 1e9;
    for (int frame = 0; frame <= frames; ++frame)
    {
      this->Renderer->GetActiveCamera()->Azimuth(1.0);
      const std::clock_t start = std::clock();
      this->Window->Render();
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      best = frame == 0 ? best : std::min(best, seconds); // The first one compiles shaders.
    }
    return best;
  }

  vtkNew<vtkBCCVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void Measure(int size, bool surface)
{
  Scene scene(size, surface);
  constexpr int Sides[] = { 2, 4, 8 };
  double plain = 1e9;
  double fixed = 1e9;
  double passes[] = { 1e9, 1e9, 1e9 };
  double small[] = { 1e9, 1e9, 1e9 };
  for (int round = 0; round < 5; ++round) // so that other work meets all of them alike
  {
    scene.Mapper->ProgressiveRefinementOff();
    plain = std::min(plain, scene.Time(2));
    scene.Volume->SetScale(1e-4);
    fixed = std::min(fixed, scene.Time(10));
    scene.Volume->SetScale(1.0);
    scene.Mapper->ProgressiveRefinementOn();
    for (int i = 0; i < 3; ++i)
    {
      scene.Mapper->SetProgressivePatternSize(Sides[i]);
      passes[i] = std::min(passes[i], scene.Time(10));
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    Scene window((size + Sides[i] - 1) / Sides[i], surface);
    small[i] = window.Time(20);
    const int pixels = Sides[i] * Sides[i];
    std::printf("%-12s %6d x %d %10.1f %10.1f %10.1f %14.2f %14.2f\n",
      surface ? "isosurface" : "composite", Sides[i], Sides[i], 1e3 * plain, 1e3 * fixed,
      1e3 * passes[i], (passes[i] - fixed) / plain * pixels, (small[i] - fixed) / plain * pixels);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 600;
  if (size < 1 || size > 8192)
  {
    std::fprintf(stderr, "BenchmarkProgressive: a window has 1 to 8192 pixels along a side\n");
    return EXIT_FAILURE;
  }
  std::printf("%-12s %10s %10s %10s %10s %14s %14s\n", "ms", "block", "at once", "fixed", "pass",
    "pass x pixels", "small window");
  Measure(size, false);
  Measure(size, true);
  return EXIT_SUCCESS;
}
