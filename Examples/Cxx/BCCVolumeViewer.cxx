// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Shows a volume file on the BCC lattice: writes a picture, or opens a window.

#include "CommandLine.h"
#include "ErrorLog.h"
#include "IsolateLargest.h"
#include "ReadVolume.h"
#include "Resample.h"
#include "Scene.h"

#include "vtkImageData.h"

#include <iostream>
#include <optional>

namespace
{

struct Options
{
  VolumeOptions Volume;
  View Look;
  Mode How = Mode::IsoSurface;
  std::vector<double> IsoValues;
  std::optional<double> Isolate;
  std::vector<int> Size = { 600, 600 };
  std::string Output = "volume.png";
  bool Interactive = false;
};

const std::map<std::string, Mode> Modes = { { "isosurface", Mode::IsoSurface },
  { "composite", Mode::Composite }, { "mip", Mode::MaximumIntensity } };

void AddOptions(CLI::App& app, Options& options)
{
  AddVolumeOptions(app, options.Volume);
  AddViewOptions(app, options.Look);
  app
    .add_option("-i,--isovalue", options.IsoValues,
      "Values to show, separated by commas; by default the middle of the volume's range")
    ->delimiter(',')
    ->check(IsFinite())
    ->type_name("V,...");
  app.add_option("--isolate", options.Isolate, "Keep only the largest region above this value")
    ->check(IsFinite())
    ->type_name("V");
  app.add_option("-m,--mode", options.How, "Rendering: isosurface, composite or mip [isosurface]")
    ->transform(CLI::CheckedTransformer(Modes, CLI::ignore_case).description(""))
    ->type_name("NAME");
  app.add_option("-s,--size", options.Size, "Width and height of the picture [600 600]")
    ->expected(2)
    ->check(CLI::Range(1, 8192).description(""))
    ->type_name("W H");
  app.add_option("-o,--output", options.Output, "Picture to write, a PNG")
    ->type_name("FILE")
    ->capture_default_str();
  app.add_flag("--interactive", options.Interactive, "Open a window instead of writing a picture");
}

/// The isovalues, checked against the volume's range, or the range's middle.
bool FindIsoValues(vtkImageData* volume, std::vector<double>& values, std::string& why)
{
  double range[2];
  volume->GetScalarRange(range);
  if (values.empty())
  {
    values = { 0.5 * (range[0] + range[1]) };
  }
  for (double value : values)
  {
    if (value < range[0] || value > range[1])
    {
      why = "isovalue " + CLI::detail::to_string(value) + " is outside the volume's values, " +
        CLI::detail::to_string(range[0]) + " to " + CLI::detail::to_string(range[1]);
      return false;
    }
  }
  return true;
}

bool Run(Options& options, std::string& why)
{
  vtkSmartPointer<vtkImageData> image = ReadVolume(options.Volume.Path, why);
  if (!image || !FindIsoValues(image, options.IsoValues, why))
  {
    return false;
  }
  if (options.Isolate)
  {
    image = IsolateLargest(image, *options.Isolate);
  }
  const vtkSmartPointer<vtkImageData> volume = ResampleToBCC(image, options.Volume.Ratio);
  if (!volume)
  {
    why = ErrorLog::TakeFirstError();
    return false;
  }
  Scene scene(options.Size[0], options.Size[1], !options.Interactive);
  scene.Show(volume, options.How, MakeSurfaces(options.IsoValues), options.Volume.Kernel,
    options.Volume.Prefilter);
  scene.LookFrom(options.Look);
  if (options.Interactive)
  {
    scene.Interact(options.Volume.Path);
    why = ErrorLog::TakeFirstError();
    return why.empty();
  }
  const double seconds = scene.Time();
  why = ErrorLog::TakeFirstError();
  if (!why.empty())
  {
    return false;
  }
  if (!WritePicture(scene.Grab(), options.Output))
  {
    why = options.Output + ": cannot be written";
    return false;
  }
  const int* n = volume->GetDimensions();
  std::cout << options.Output << ": " << n[0] << " x " << n[1] << " x " << n[2] << " samples, "
            << NameOfKernel(options.Volume.Kernel) << ", " << seconds << " s a frame\n";
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Shows a volume on the body-centred cubic lattice, reconstructed by a box-spline.");
  AddOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  ErrorLog::Install();
  std::string why;
  if (!Run(options, why))
  {
    std::cerr << "BCCVolumeViewer: error: " << why << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
