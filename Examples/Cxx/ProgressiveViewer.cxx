// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A volume that is coarse while the mouse drags it, and completes when the mouse rests.

#include "CommandLine.h"
#include "ErrorLog.h"
#include "ReadVolume.h"
#include "Resample.h"

#include "vtkBCCVolumeMapper.h"
#include "vtkBCCVolumeSource.h"
#include "vtkDataArray.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <iostream>
#include <optional>

namespace
{

struct Options
{
  VolumeOptions Volume;
  View Look;
  std::optional<double> IsoValue;
  int Block = 4;
  int Size = 500;
  bool Composite = false;
  std::string Output;
};

void AddOptions(CLI::App& app, Options& options)
{
  AddVolumeOptions(app, options.Volume);
  AddViewOptions(app, options.Look);
  app.get_option("volume")->required(false);
  app.add_option("-i,--isovalue", options.IsoValue, "Value to show [the middle of the range]")
    ->check(IsFinite())
    ->type_name("V");
  app.add_option("--block", options.Block, "A pass has one ray of N x N pixels: 2, 4 or 8")
    ->check(CLI::IsMember({ 2, 4, 8 }).description(""))
    ->type_name("N")
    ->capture_default_str();
  app.add_option("-s,--size", options.Size, "Width and height of the picture")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("N")
    ->capture_default_str();
  app.add_flag("--composite", options.Composite, "Draw all of the volume, not a surface of it");
  app
    .add_option("-o,--output", options.Output,
      "Open no window: drag once, and write the passes 1, 4 and 16 that follow, side by side")
    ->type_name("FILE");
}

/// A window in which the passes follow each other, a timer's tick at a time.
class Viewer
{
public:
  Viewer(Scene& scene, int block)
    : Stage(scene)
    , Mapper(vtkBCCVolumeMapper::SafeDownCast(scene.GetMapper()))
  {
    this->Mapper->SetProgressivePatternSize(block);
    this->Interactor->SetRenderWindow(scene.GetWindow());
    this->Interactor->SetInteractorStyle(this->Style);
    this->Style->AddObserver(vtkCommand::StartInteractionEvent, this, &Viewer::Begin);
    this->Interactor->AddObserver(vtkCommand::TimerEvent, this, &Viewer::Continue);
    this->Mapper->AddObserver(vtkBCCVolumeMapper::ProgressCompleteEvent, this, &Viewer::End);
    this->Interactor->Initialize();
    scene.GetWindow()->Render();
  }

  bool IsComplete() const { return this->Mapper->GetProgressComplete(); }

  void Run()
  {
    this->Interactor->CreateRepeatingTimer(10);
    this->Interactor->Start();
  }

  /// As the user does: press and move, which draws the first pass.
  void Drag()
  {
    this->Interactor->SetEventInformation(100, 100);
    this->Interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    this->Interactor->SetEventInformation(130, 105);
    this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }

  /// VTK draws when a button is released: that is the second pass.
  void Rest() { this->Interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent); }

  /// A pass more, if there is one.
  void Continue()
  {
    if (!this->IsComplete())
    {
      this->Stage.GetWindow()->Render();
    }
  }

  /// All rays at once.
  void DrawPlain()
  {
    this->Mapper->ProgressiveRefinementOff();
    this->Stage.GetWindow()->Render();
  }

  vtkSmartPointer<vtkImageData> Grab()
  {
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->DeepCopy(this->Stage.Grab());
    return picture;
  }

private:
  void Begin() { this->Mapper->ProgressiveRefinementOn(); }
  void End() { std::cout << "complete" << std::endl; }

  Scene& Stage;
  vtkBCCVolumeMapper* Mapper;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> Style;
};

/// Milliseconds of processors.
template <class F>
double Measure(F&& what)
{
  const std::clock_t start = std::clock();
  what();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

bool AreEqual(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* pixels = a->GetPointData()->GetScalars();
  return pixels->GetNumberOfValues() == b->GetPointData()->GetScalars()->GetNumberOfValues() &&
    std::memcmp(pixels->GetVoidPointer(0), b->GetPointData()->GetScalars()->GetVoidPointer(0),
      static_cast<std::size_t>(pixels->GetNumberOfValues())) == 0;
}

bool WritePasses(Viewer& viewer, const std::string& path)
{
  const double plain = Measure([&] { viewer.DrawPlain(); });
  viewer.Drag();
  vtkNew<vtkImageAppend> shown;
  shown->AddInputData(viewer.Grab());
  double time = Measure([&] { viewer.Rest(); });
  int passes = 2;
  while (!viewer.IsComplete())
  {
    time += Measure([&] { viewer.Continue(); });
    if (++passes == 4 || passes == 16)
    {
      shown->AddInputData(viewer.Grab());
    }
  }
  const vtkSmartPointer<vtkImageData> last = viewer.Grab();
  viewer.DrawPlain();
  std::cout << passes << " passes of " << time / (passes - 1) << " ms, at once " << plain
            << " ms; the last picture " << (AreEqual(viewer.Grab(), last) ? "is" : "is not")
            << " the plain one\n";
  shown->Update();
  return WritePicture(shown->GetOutput(), path);
}

vtkSmartPointer<vtkImageData> Load(const VolumeOptions& options, std::string& why)
{
  if (options.Path.empty())
  {
    vtkNew<vtkBCCVolumeSource> source; // the Marschner-Lobb function
    source->Update();
    return source->GetOutput();
  }
  const vtkSmartPointer<vtkImageData> image = ReadVolume(options.Path, why);
  vtkSmartPointer<vtkImageData> volume = image ? ResampleToBCC(image, options.Ratio) : nullptr;
  if (image && !volume)
  {
    why = ErrorLog::TakeFirstError();
  }
  return volume;
}

bool Run(const Options& options, std::string& why)
{
  const vtkSmartPointer<vtkImageData> volume = Load(options.Volume, why);
  if (!volume)
  {
    return false;
  }
  double range[2];
  volume->GetScalarRange(range);
  const double value = options.IsoValue.value_or(0.5 * (range[0] + range[1]));
  Scene scene(options.Size, options.Size, !options.Output.empty());
  scene.Show(volume, options.Composite ? Mode::Composite : Mode::IsoSurface,
    MakeSurfaces({ value }), options.Volume.Kernel, options.Volume.Prefilter);
  scene.LookFrom(options.Look);
  scene.GetWindow()->SetWindowName("Bravais: progressive refinement");
  Viewer viewer(scene, options.Block);
  const bool written = options.Output.empty() || WritePasses(viewer, options.Output);
  if (options.Output.empty())
  {
    viewer.Run();
  }
  why = written ? ErrorLog::TakeFirstError() : options.Output + ": cannot be written";
  return why.empty();
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Opens a window with a volume, by default the Marschner-Lobb function, that is "
               "coarse while the mouse drags it and completes when the mouse rests.");
  AddOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  ErrorLog::Install();
  std::string why;
  if (!Run(options, why))
  {
    std::cerr << "ProgressiveViewer: error: " << why << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
