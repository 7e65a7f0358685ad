// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Rank-1 lattices: how long the search for the best one takes; look-ups of each interpolation
// beside vtkImageInterpolator's linear one at as many texels; what the layout Locality gains; and
// how fast a picture is resampled, beside vtkImageResize and OpenImageIO's resize to as many
// pixels.
//
//   BenchmarkRank1 [side of the picture that is resampled]

#include "RatioReporter.h"

#include "Rank1LookUp.h"
#include "Rank1Search.h"
#include "vtkRank1ImageReconstruct.h"
#include "vtkRank1ImageResample.h"

#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkImageResize.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <random>

namespace
{

using bravais::Rank1Interpolation;
using bravais::Rank1Lattice;
using Points = std::vector<glm::dvec2>;

struct Mode
{
  const char* Name;
  Rank1Interpolation Interpolation;
};

constexpr Mode Modes[] = { { "nearest", Rank1Interpolation::Nearest },
  { "bilinear", Rank1Interpolation::Bilinear }, { "barycentric", Rank1Interpolation::Barycentric },
  { "box-spline", Rank1Interpolation::BoxSpline } };

/// Processor time of the quickest of several runs, in milliseconds.
template <class Work>
double Measure(const Work& work)
{
  double least = 1e9;
  for (int repeat = 0; repeat < 5; ++repeat)
  {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

void PrintSearch()
{
  std::printf("Search for the best lattice, milliseconds of one thread\n");
  std::printf(
    "%12s %12s %12s %12s %14s\n", "points", "area 1 : 1", "area 16 : 9", "efficiency", "generator");
  for (const std::int64_t n : { 1 << 12, 1 << 18, 1 << 22, 1 << 24, 16777213, 0x7fffffff })
  {
    std::optional<Rank1Lattice> lattice;
    const double square = Measure([&] { lattice = bravais::MaximizeMinimumDistance(n); });
    const double wide = Measure(
      [&] {
        benchmark::DoNotOptimize(bravais::MaximizeMinimumDistance(n, { 16.0, 9.0 }));
      });
    std::printf("%12lld %12.2f %12.2f %12.5f  (%lld, %lld)\n", static_cast<long long>(n), square,
      wide, lattice->GetSamplingEfficiency(), static_cast<long long>(lattice->GetGenerator().x),
      static_cast<long long>(lattice->GetGenerator().y));
  }
  std::printf("\n");
}

/// Points of the unit square: anywhere, or along rows of a turned raster, a texel's width apart.
Points MakePoints(int count, double step)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  Points points;
  const int row = 1024;
  const glm::dvec2 along = step * glm::dvec2(std::cos(0.7), std::sin(0.7));
  const glm::dvec2 across(-along.y, along.x);
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec2 p = step > 0.0 ? glm::dvec2(0.1) + static_cast<double>(i % row) * along +
        static_cast<double>(i / row) * across
                                    : glm::dvec2(anywhere(generator), anywhere(generator));
    points.push_back(p - glm::floor(p));
  }
  return points;
}

template <class T>
void AddLookUps(const std::string& name, const Rank1Lattice& lattice, const Mode& mode,
  const std::vector<float>& texels, const Points& points)
{
  bravais::AddBenchmark(name, static_cast<double>(points.size()),
    [&, mode, texture = bravais::MakeRank1Texture<T>(lattice)]
    {
      T sum(0);
      for (const glm::dvec2& uv : points)
      {
        bravais::AddRank1Value(
          texture, mode.Interpolation, glm::vec<2, T>(uv), texels.data(), 1, T(1), &sum);
      }
      benchmark::DoNotOptimize(sum);
    });
}

/// One float a texel, one thread, at points along turned rows or anywhere.
void RunLookUps(int log2, bool random)
{
  const int side = 1 << (log2 / 2);
  const std::int64_t n = std::int64_t{ side } * side;
  const Points points = MakePoints(1 << 20, random ? 0.0 : 1.0 / side);
  const std::vector<float> texels(n, 1.0f);
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(texels.begin(), texels.end(), static_cast<float*>(image->GetScalarPointer()));
  vtkNew<vtkImageInterpolator> interpolator;
  interpolator->SetInterpolationModeToLinear();
  interpolator->SetBorderModeToRepeat();
  interpolator->Initialize(image);
  benchmark::ClearRegisteredBenchmarks();
  bravais::AddBenchmark("vtkImageInterpolator, linear", static_cast<double>(points.size()),
    [&]
    {
      double sum = 0.0;
      for (const glm::dvec2& uv : points)
      {
        const double x[3] = { uv.x * side, uv.y * side, 0.0 };
        double value = 0.0;
        interpolator->Interpolate(x, &value);
        sum += value;
      }
      benchmark::DoNotOptimize(sum);
    });
  const Rank1Lattice korobov = *bravais::MaximizeMinimumDistance(n);
  const Rank1Lattice local = bravais::ChooseGenerator(korobov, bravais::Rank1Layout::Locality);
  std::printf("%d^2 texels, points %s; layout measure of 16 texels a line: Korobov %.3f, Locality "
              "%.3f\n",
    side, random ? "anywhere" : "along turned rows", bravais::MeasureLayout(korobov, 16),
    bravais::MeasureLayout(local, 16));
  for (const Mode& mode : Modes)
  {
    AddLookUps<double>(std::string(mode.Name) + ", Korobov", korobov, mode, texels, points);
    AddLookUps<double>(std::string(mode.Name) + ", Locality", local, mode, texels, points);
    AddLookUps<float>(std::string(mode.Name) + ", Locality, as float", local, mode, texels, points);
  }
  bravais::RatioReporter reporter("M look-ups/s", { "vtkImageInterpolator, linear" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\n");
}

template <class Filter>
void AddFilter(const std::string& name, double pixels, const vtkSmartPointer<Filter>& filter)
{
  bravais::AddBenchmark(name, pixels,
    [=]
    {
      filter->Modified();
      filter->Update();
    });
}

void AddOIIO(const std::string& name, double pixels, const OIIO::ImageBuf& source, int side)
{
  bravais::AddBenchmark(name, pixels,
    [&source, side]
    {
      benchmark::DoNotOptimize(
        OIIO::ImageBufAlgo::resize(source, "box", 0.0f, OIIO::ROI(0, side, 0, side, 0, 1, 0, 3)));
    });
}

/// A picture of three bytes a pixel to so many texels or pixels, all threads.
void RunResampling(vtkImageData* image, int side, int target)
{
  const double pixels = static_cast<double>(target) * target;
  const OIIO::ImageBuf source(
    OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::UINT8), image->GetScalarPointer());
  benchmark::ClearRegisteredBenchmarks();
  auto resize = vtkSmartPointer<vtkImageResize>::New();
  resize->SetInputData(image);
  resize->SetOutputDimensions(target, target, 1);
  resize->BorderOn();
  AddFilter("vtkImageResize", pixels, resize);
  AddOIIO("OpenImageIO, box", pixels, source, target);
  for (const int layout : { vtkRank1ImageResample::Korobov, vtkRank1ImageResample::Locality })
  {
    for (const int filter : { vtkRank1ImageResample::Box, vtkRank1ImageResample::Bilinear,
           vtkRank1ImageResample::Bicubic, vtkRank1ImageResample::Nearest })
    {
      auto rank1 = vtkSmartPointer<vtkRank1ImageResample>::New();
      rank1->SetInputData(image);
      rank1->SetNumberOfPoints(vtkIdType{ target } * target);
      rank1->SetFilter(filter);
      rank1->SetLayout(layout);
      AddFilter(
        std::string(rank1->GetFilterAsString()) + ", " + rank1->GetLayoutAsString(), pixels, rank1);
    }
  }
  auto rank1 = vtkSmartPointer<vtkRank1ImageResample>::New();
  rank1->SetInputData(image);
  rank1->SetNumberOfPoints(vtkIdType{ target } * target);
  rank1->Update();
  auto back = vtkSmartPointer<vtkRank1ImageReconstruct>::New();
  back->SetInputData(rank1->GetOutput());
  back->SetOutputDimensions(target, target);
  AddFilter("vtkRank1ImageReconstruct, Barycentric", pixels, back);
  std::printf("%d^2 pixels of 3 bytes to %d^2 texels\n", side, target);
  bravais::RatioReporter reporter("M texels/s", { "vtkImageResize", "OpenImageIO, box" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 4096;
  if (side < 16 || side > 16384)
  {
    std::fprintf(stderr, "usage: %s [side of the picture, 16 to 16384]\n", argv[0]);
    return 1;
  }
  benchmark::Initialize(&argc, argv);
  PrintSearch();
  for (const int log2 : { 18, 24 })
  {
    RunLookUps(log2, false);
    RunLookUps(log2, true);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::int64_t i = 0; i < std::int64_t{ 3 } * side * side; ++i)
  {
    bytes[i] = static_cast<unsigned char>(i * 7919 >> 5);
  }
  RunResampling(image, side, side - 1); // as many, but not the same pixels
  RunResampling(image, side, side / 4);
  return 0;
}
