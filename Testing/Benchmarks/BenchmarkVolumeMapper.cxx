// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Frame times of vtkBCCVolumeMapper beside VTK's own mapper on Cartesian volumes of as many
/// samples: the rows of Table 1 of Kim and Lee, Real-time BCC Volume Isosurface Ray Casting on the
/// GPU, other blend modes, and how times grow with volume and image.

#include "VolumeMapperScene.h"

#include <CLI/CLI.hpp>

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
  std::vector<int> Sizes = { 64, 128 };
  std::vector<int> Images = { 256, 512, 1024 };
  std::string Volume;
  double IsoValue = 300.0;
  int Frames = 5;
  double Scale = 1.0;
  double ImageScale = 1.0;
  bool Clock = false;
};

double Get(const Options& options, const FrameTime& time)
{
  return 1e3 * (options.Clock ? time.Clock : time.Processor);
}

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
  double peer = 0.0;
  double first = 0.0;
  for (const MapperChoice& choice : GetChoices(options))
  {
    const FrameTime time = TimeFrames(pair, choice, mode, options.Frames);
    peer = choice.Kernel == 0 ? Get(options, time) : peer;
    const double change = 1e3 * (options.Clock ? time.FirstClock : time.FirstProcessor);
    first = choice.Kernel == 0 ? change : first;
    std::printf("%-22s %10.1f %8.2f %12.1f %8.2f %8.1f\n", choice.Name.c_str(), Get(options, time),
      Get(options, time) / peer, change, change / first, 1e-6 * time.Memory);
    std::fflush(stdout);
  }
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
  std::printf("\nIsosurfaces, frames a second without and with skipping\n%-14s %14s", "volume",
    "VTK trilinear");
  for (const int kernel : options.Kernels)
  {
    std::printf(" %13s%-3d", "bcc", kernel);
  }
  std::printf("  bcc7/bcc8 bcc7/bcc12\n");
  for (const VolumePair& pair : MakePaperPairs(options))
  {
    std::printf("%-14s", pair.Name.c_str());
    double rate[2][13] = {};
    for (const MapperChoice& choice : GetChoices(options))
    {
      const double frame =
        1e3 / Get(options, TimeFrames(pair, choice, RenderMode::IsoSurface, options.Frames));
      rate[choice.Skip][choice.Kernel] = frame;
      std::printf(choice.Kernel == 0 ? " %14.2f" : " %7.2f", frame);
      std::fflush(stdout);
    }
    std::printf("  %4.2f %4.2f  %4.2f %4.2f\n", rate[0][7] / rate[0][8], rate[1][7] / rate[1][8],
      rate[0][7] / rate[0][12], rate[1][7] / rate[1][12]);
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
  app.add_option("--frames", options.Frames, "Frames of which the fastest counts");
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
