// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast a volume is quantised, beside VTK's filters that also make one byte of every sample:
// shift and scale, which rounds, and a lookup table. All threads are used by all.
//
//   BenchmarkDither [points along each axis]

#include "RatioReporter.h"

#include "vtkOrderedDither.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageMapToColors.h"
#include "vtkImageShiftScale.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cstdlib>

namespace
{

constexpr int Levels = 4;
constexpr int Highest = 100; // fits all types

vtkSmartPointer<vtkImageData> MakeImage(int n, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    scalars->SetTuple1(point, static_cast<double>(point * 7919 % (Highest + 1)));
  }
  return image;
}

void AddFilter(const std::string& name, vtkImageAlgorithm* algorithm, vtkImageData* image)
{
  const vtkSmartPointer<vtkImageAlgorithm> filter = algorithm;
  filter->SetInputData(image);
  bravais::AddBenchmark(name, static_cast<double>(image->GetNumberOfPoints()),
    [=]
    {
      filter->Modified();
      filter->Update();
    });
}

void AddPeers(vtkImageData* image)
{
  vtkNew<vtkImageShiftScale> scale;
  scale->SetScale((Levels - 1.0) / Highest);
  scale->SetShift(0.5 / scale->GetScale());
  scale->SetOutputScalarTypeToUnsignedChar();
  AddFilter("vtkImageShiftScale", scale, image);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(Levels);
  table->SetTableRange(0, Highest);
  table->Build();
  vtkNew<vtkImageMapToColors> colors;
  colors->SetLookupTable(table);
  colors->SetOutputFormatToLuminance();
  AddFilter("vtkImageMapToColors", colors, image);
}

void AddDither(vtkImageData* image, int dimensionality, int log2Size)
{
  vtkNew<vtkOrderedDither> dither;
  dither->SetNumberOfLevels(Levels);
  dither->SetInputRange(0, Highest);
  dither->SetDimensionality(dimensionality);
  dither->SetPatternLog2Size(log2Size);
  AddFilter("vtkOrderedDither, " + std::to_string(dimensionality) + "D pattern of side " +
      std::to_string(1 << log2Size),
    dither, image);
}

} // namespace

int main(int argc, char* argv[])
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 256;
  if (n < 1 || n > 1024)
  {
    std::fprintf(stderr, "usage: %s [points along each axis, 1 to 1024]\n", argv[0]);
    return 1;
  }
  benchmark::Initialize(&argc, argv);
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    std::printf(
      "%d^3 points of type %s to %d levels\n", n, vtkImageScalarTypeNameMacro(type), Levels);
    vtkSmartPointer<vtkImageData> image = MakeImage(n, type);
    benchmark::ClearRegisteredBenchmarks();
    AddPeers(image);
    for (const int log2Size : { 0, 3, 7 })
    {
      AddDither(image, 2, log2Size);
      AddDither(image, 3, log2Size);
    }
    bravais::RatioReporter reporter("M points/s", { "vtkImageShiftScale", "vtkImageMapToColors" });
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\n");
  }
  return 0;
}
