// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Frame times of vtkBCCVolumeMapper beside VTK's own mapper on Cartesian volumes of as many
/// samples: the rows of Table 1 of Kim and Lee, Real-time BCC Volume Isosurface Ray Casting on the
/// GPU, other blend modes, and how times grow with volume and image.

#include "VolumeMapperScene.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "vtkImageData.h"

using namespace bravais;

namespace
{

struct Options
{
  std::vector<std::string> Tables = { "paper", "modes", "scaling" };
  std::vector<int> Modes = { 0, 1, 2, 3 };
  int Image = 512;
  std::vector<int> Kernels = { 12, 8, 7, 4 };
  std::vector<int> Sizes = { 64, 128, 256, 384 };
  std::vector<int> Images = { 256, 512, 1024 };
  std::string Volume;
  double IsoValue = 300.0;
  int Frames = 5;
  double Scale = 1.0;
  double ImageScale = 1.0;
  bool Clock = false;
};

std::vector<MapperChoice> GetChoices(const Options& options)
{
  std::vector<MapperChoice> choices = { { "VTK trilinear", 0, false } };
  for (const int kernel : options.Kernels)
  {
    choices.push_back({ "bcc" + std::to_string(kernel) + ", no skipping", kernel, false });
    choices.push_back({ "bcc" + std::to_string(kernel), kernel, true });
  }
  return choices;
}

/// What kernels take of bcc7's time, without and with skipping.
void PrintKernels(const std::vector<MapperChoice>& choices, const std::vector<FrameTimes>& times)
{
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto bcc7 = std::find_if(choices.begin(), choices.end(),
      [&](const MapperChoice& choice)
      { return choice.Kernel == 7 && choice.Skip == choices[i].Skip; });
    if (choices[i].Kernel != 0 && choices[i].Kernel != 7 && bcc7 != choices.end())
    {
      std::printf("%s / %s: %.2f\n", choices[i].Name.c_str(), bcc7->Name.c_str(),
        times[i].GetRatio(times[bcc7 - choices.begin()]));
    }
  }
}

/// One line a mapper: time of a frame, what it is of VTK's, and the same of the first frame.
void PrintPair(const Options& options, const VolumePair& pair, RenderMode mode)
{
  std::printf("\n%s, %s, %d x %d x %d samples (VTK %d x %d x %d), image %d x %d\n",
    pair.Name.c_str(), GetName(mode), pair.BCC->GetDimensions()[0], pair.BCC->GetDimensions()[1],
    pair.BCC->GetDimensions()[2], pair.Cartesian->GetDimensions()[0],
    pair.Cartesian->GetDimensions()[1], pair.Cartesian->GetDimensions()[2], pair.Width,
    pair.Height);
  std::printf(
    "%-22s %10s %8s %12s %8s %8s\n", "", "frame, ms", "/ VTK", "first, ms", "/ VTK", "MB");
  const std::vector<MapperChoice> choices = GetChoices(options);
  const std::vector<FrameTimes> times =
    TimeFrames(pair, choices, mode, options.Frames, options.Clock);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    std::printf("%-22s %10.1f %8.2f %12.1f %8.2f %8.1f\n", choices[i].Name.c_str(),
      1e3 * times[i].Fastest, times[i].GetRatio(times[0]), 1e3 * times[i].First,
      times[i].First / times[0].First, 1e-6 * times[i].Memory);
  }
  PrintKernels(choices, times);
  std::fflush(stdout);
}

int Round(double size)
{
  return static_cast<int>(size) / 2 * 2;
}

/// The volumes of Table 1: heads of ellipsoids where the originals cannot be had.
std::vector<VolumePair> MakePaperPairs(const Options& options)
{
  const double s = options.Scale;
  const double i = s * options.ImageScale;
  const int image = Round(512 * i);
  const auto head = [&](const char* name, int nx, int ny, int nk)
  {
    const int size[3] = { Round(nx * s), Round(ny * s), Round(nk * s) };
    return MakeHead(name, size, image, image);
  };
  std::vector<VolumePair> pairs = { head("as CT-Head", 128, 128, 112), head("as Carp", 64, 64, 256),
    head("as MRI-Head", 128, 128, 256), head("as VisMale", 64, 128, 256) };
  for (const int n : { 39, 31, 26, 22, 19 })
  {
    pairs.push_back(MakeMarschnerLobb(n, Round(480 * i), Round(320 * i)));
  }
  return pairs;
}

void PrintPaperTable(const Options& options)
{
  const std::vector<MapperChoice> choices = GetChoices(options);
  for (const VolumePair& pair : MakePaperPairs(options))
  {
    const std::vector<FrameTimes> times =
      TimeFrames(pair, choices, RenderMode::IsoSurface, options.Frames, options.Clock);
    std::printf("\n%s, isosurface, image %d x %d, frames a second and as a multiple of VTK's\n",
      pair.Name.c_str(), pair.Width, pair.Height);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      std::printf("%-22s %8.2f %8.2f\n", choices[i].Name.c_str(), 1.0 / times[i].Fastest,
        1.0 / times[i].GetRatio(times[0]));
    }
    PrintKernels(choices, times);
    std::fflush(stdout);
  }
}

void PrintScaling(const Options& options)
{
  for (const int size : options.Sizes)
  {
    // As many samples as a cube of that edge.
    const int n = Round(size * 0.5 * std::cbrt(4.0));
    const int dimensions[3] = { n, n, 2 * n };
    for (const int image : options.Images)
    {
      PrintPair(options, MakeHead("head " + std::to_string(size), dimensions, image, image),
        RenderMode::IsoSurface);
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Times vtkBCCVolumeMapper beside VTK's own mapper.");
  app.add_option("--tables", options.Tables, "paper, modes, scaling")->delimiter(',');
  app
    .add_option("--modes", options.Modes,
      "Of the table of modes: 0 isosurface, 1 composite, 2 composite and shaded, 3 maximum")
    ->delimiter(',')
    ->check(CLI::Range(0, 3));
  app.add_option("--image", options.Image, "Width of the image, of modes");
  app.add_option("--kernels", options.Kernels, "4, 7, 8, 12")->delimiter(',');
  app.add_option("--sizes", options.Sizes, "Edges of cubes of samples, of scaling")->delimiter(',');
  app.add_option("--images", options.Images, "Widths of the image, of scaling")->delimiter(',');
  app.add_option("--volume", options.Volume, "A MetaImage file for the table of modes");
  app.add_option("--iso-value", options.IsoValue, "Its isovalue");
  app.add_option(
    "--frames", options.Frames, "Frames of each, by turns: the fastest and the median ratio count");
  app.add_option("--scale", options.Scale, "Scales the paper's volumes and images");
  app.add_option("--image-scale", options.ImageScale, "Scales the paper's images alone");
  app.add_flag("--clock", options.Clock, "Time by the clock, not of the processors");
  CLI11_PARSE(app, argc, argv);
  for (const std::string& table : options.Tables)
  {
    if (table == "paper")
    {
      PrintPaperTable(options);
    }
    else if (table == "scaling")
    {
      PrintScaling(options);
    }
    else
    {
      const int size[3] = { Round(128 * options.Scale), Round(128 * options.Scale),
        Round(112 * options.Scale) };
      const int image = options.Image;
      const VolumePair pairs[] = { options.Volume.empty()
          ? MakeHead("as CT-Head", size, image, image)
          : ReadPair(options.Volume, options.IsoValue, image, image),
        MakeMarschnerLobb(Round(88 * options.Scale), image, image) };
      for (const VolumePair& pair : pairs)
      {
        if (!pair.BCC)
        {
          std::fprintf(stderr, "Cannot read %s\n", options.Volume.c_str());
          return EXIT_FAILURE;
        }
        for (const int mode : options.Modes)
        {
          PrintPair(options, pair, static_cast<RenderMode>(mode));
        }
      }
    }
  }
  return EXIT_SUCCESS;
}
