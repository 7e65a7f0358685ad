// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Draws a volume and the Marschner-Lobb function on the BCC lattice, beside VTK's trilinear mapper
/// on Cartesian grids of as many samples, and prints a table.

#include "DemoMarschnerLobb.h"
#include "DemoVolume.h"
#include "ErrorLog.h"
#include "Gallery.h"
#include "IsolateLargest.h"
#include "ReadVolume.h"

#include "vtkImageData.h"

#include <iostream>
#include <optional>

namespace
{

struct Options
{
  DemoOptions Demo;
  std::optional<double> Isolate;
  std::vector<double> DetailFocus = { 0.5, 0.5, 0.5 };
  double DetailZoom = 4.0;
  int Size = 600;
  std::string Folder = "demo";
};

void AddOptions(CLI::App& app, Options& options)
{
  AddVolumeOptions(app, options.Demo.Volume);
  AddViewOptions(app, options.Demo.Look);
  app.get_option("volume")->required(false);
  app.add_option("--inner", options.Demo.Inner, "Isovalue of what is inside, such as bone")
    ->check(IsFinite())
    ->type_name("V");
  app.add_option("--outer", options.Demo.Outer, "Isovalue of what is about it, such as skin")
    ->check(IsFinite())
    ->type_name("V");
  app.add_option("--isolate", options.Isolate, "Keep only the largest region above this value")
    ->check(IsFinite())
    ->type_name("V");
  app.add_option("--detail", options.DetailFocus, "Middle of the detail, in fractions of the box")
    ->expected(3)
    ->check(IsFinite())
    ->type_name("X Y Z")
    ->group("View");
  app.add_option("--detail-zoom", options.DetailZoom, "Magnification of the detail")
    ->check(IsFinite() & CLI::PositiveNumber)
    ->type_name("NUMBER")
    ->capture_default_str()
    ->group("View");
  app.add_option("-s,--size", options.Size, "Width and height of the pictures")
    ->check(CLI::Range(2, 8192).description(""))
    ->type_name("N")
    ->capture_default_str();
  app.add_option("-o,--output", options.Folder, "Folder for the pictures")
    ->type_name("FOLDER")
    ->capture_default_str();
}

vtkSmartPointer<vtkImageData> Load(const Options& options, std::string& why)
{
  vtkSmartPointer<vtkImageData> image = ReadVolume(options.Demo.Volume.Path, why);
  if (image && options.Isolate)
  {
    image = IsolateLargest(image, *options.Isolate);
    why = ErrorLog::TakeFirstError();
  }
  return image;
}

bool Run(Options& options, std::string& why)
{
  const bool hasVolume = !options.Demo.Volume.Path.empty();
  vtkSmartPointer<vtkImageData> image;
  if (hasVolume)
  {
    image = Load(options, why);
    if (!image)
    {
      return false;
    }
    std::cout << "Read " << options.Demo.Volume.Path << std::endl;
  }
  Gallery gallery(
    options.Folder, options.Size, MarschnerLobbPictures + (hasVolume ? VolumePictures : 0));
  options.Demo.Detail = options.Demo.Look;
  options.Demo.Detail.Zoom = options.DetailZoom;
  std::copy_n(options.DetailFocus.begin(), 3, options.Demo.Detail.Focus);
  if ((hasVolume && !DrawVolume(gallery, image, options.Demo, why)) ||
    !DrawMarschnerLobb(gallery, why))
  {
    return false;
  }
  std::cout << '\n';
  gallery.GetTable().Print(std::cout);
  std::cout << "\nPictures: " << options.Folder << std::endl;
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Draws a volume, if one is given, and the Marschner-Lobb function on the "
               "body-centred cubic lattice, and by VTK's trilinear mapper on Cartesian grids with "
               "as many samples.");
  AddOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  ErrorLog::Install();
  std::string why;
  if (!Run(options, why))
  {
    std::cerr << "BCCDemo: error: " << why << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
