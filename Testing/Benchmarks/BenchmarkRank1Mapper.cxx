// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast a lit surface is drawn with a rank-1 texture in each mode, beside VTK's own mapper with
// a vtkTexture of as many texels, and with none: a receding plane of two triangles that fills the
// window, where nothing but fragments count, and the same plane of half a million. In processor
// time, which is the frame's where OpenGL is software; with a GPU it is the driver's alone.
//
//   BenchmarkRank1Mapper [columns and rows of the window]

#include "RatioReporter.h"

#include "Rank1Image.h"
#include "Rank1Search.h"
#include "vtkRank1TexturedPolyDataMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <cstdlib>

namespace
{

constexpr int Side = 512; // of the square texture

void FillWithColors(vtkImageData* image)
{
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < 3 * image->GetNumberOfPoints(); ++i)
  {
    values[i] = static_cast<unsigned char>(i * 7919 % 251);
  }
}

vtkSmartPointer<vtkImageData> MakeRank1(
  int n, bravais::Rank1Layout layout = bravais::Rank1Layout::Korobov, int tiles = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, tiles, tiles);
  FillWithColors(image);
  const double domain[4] = { 0.0, 1.0, 0.0, 1.0 };
  const auto lattice = bravais::MaximizeMinimumDistance(n);
  bravais::TagRank1Image(image, bravais::ChooseGenerator(*lattice, layout), domain);
  return image;
}

vtkSmartPointer<vtkMultiBlockDataSet> MakePyramid(int n)
{
  auto levels = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int level = 0; n > 0; ++level, n /= 4)
  {
    levels->SetBlock(level, MakeRank1(n));
  }
  return levels;
}

/// The unit square with normals and texture coordinates, of so many squares a side.
vtkSmartPointer<vtkPolyData> MakePlane(int squares)
{
  auto plane = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polygons;
  for (int j = 0; j <= squares; ++j)
  {
    for (int i = 0; i <= squares; ++i)
    {
      const double u = static_cast<double>(i) / squares;
      const double v = static_cast<double>(j) / squares;
      points->InsertNextPoint(u, v, 0.0);
      normals->InsertNextTuple3(0.0, 0.0, 1.0);
      coordinates->InsertNextTuple2(u, v);
      if (i < squares && j < squares)
      {
        const vtkIdType corner = static_cast<vtkIdType>(j) * (squares + 1) + i;
        const vtkIdType cell[4] = { corner, corner + 1, corner + squares + 2,
          corner + squares + 1 };
        polygons->InsertNextCell(4, cell);
      }
    }
  }
  plane->SetPoints(points);
  plane->SetPolys(polygons);
  plane->GetPointData()->SetNormals(normals);
  plane->GetPointData()->SetTCoords(coordinates);
  return plane;
}

struct View
{
  std::string Prefix;
  int Size;
  int Squares;
};

/// Frames of the plane from near its front edge, which reaches beyond the window's.
void AddFrames(const std::string& name, const View& view, vtkPolyDataMapper* mapper,
  vtkTexture* texture = nullptr)
{
  const int size = view.Size;
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(size, size);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkActor> actor;
  mapper->SetInputData(MakePlane(view.Squares));
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.5, 0.1, 0.12);
  camera->SetFocalPoint(0.5, 0.35, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();
  window->Render(); // compiles the shader
  benchmark::RegisterBenchmark((view.Prefix + name).c_str(),
    [=](benchmark::State& state)
    {
      for (auto _ : state)
      {
        window->Render();
        window->WaitForCompletion();
      }
      state.SetItemsProcessed(static_cast<std::int64_t>(size) * size * state.iterations());
    })
    ->MeasureProcessCPUTime()
    ->MinTime(0.2)
    ->Repetitions(5);
}

void AddPeers(const View& view)
{
  AddFrames("no texture", view, vtkSmartPointer<vtkPolyDataMapper>::New());
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(Side, Side, 1);
  FillWithColors(picture);
  for (int kind = 0; kind < 4; ++kind)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(picture);
    texture->SetInterpolate(kind > 0);
    texture->SetMipmap(kind > 1);
    texture->SetMaximumAnisotropicFiltering(kind > 2 ? 4.0f : 1.0f); // 4 is VTK's default
    const char* names[] = { "VTK nearest", "VTK linear", "VTK mipmaps",
      "VTK mipmaps, anisotropic" };
    AddFrames(names[kind], view, vtkSmartPointer<vtkPolyDataMapper>::New(), texture);
  }
}

void AddRank1(const std::string& name, const View& view, vtkDataObject* texture, int interpolation,
  int levelFilter = 1)
{
  const auto mapper = vtkSmartPointer<vtkRank1TexturedPolyDataMapper>::New();
  mapper->SetTextureData(texture);
  mapper->SetInterpolation(interpolation);
  mapper->SetLevelFilter(levelFilter);
  AddFrames(name, view, mapper);
}

}

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 512;
  if (size < 16)
  {
    std::fprintf(stderr, "%s is no window's size; at least 16 was expected.\n", argv[1]);
    return EXIT_FAILURE;
  }
  const View view{ "", size, 1 };
  AddPeers(view);
  const auto texture = MakeRank1(Side * Side);
  AddRank1("rank-1 nearest", view, texture, 0);
  AddRank1("rank-1 bilinear", view, texture, 1);
  AddRank1("rank-1 barycentric", view, texture, 2);
  AddRank1("rank-1 box-spline", view, texture, 3);
  AddRank1("rank-1 barycentric, for locality", view,
    MakeRank1(Side * Side, bravais::Rank1Layout::Locality), 2);
  AddRank1("rank-1 barycentric, no power of two", view, MakeRank1(Side * Side - 1), 2);
  AddRank1("rank-1 barycentric, 2 x 2 tiles", view,
    MakeRank1(Side * Side / 4, bravais::Rank1Layout::Korobov, 2), 2);
  const auto pyramid = MakePyramid(Side * Side);
  AddRank1("rank-1 barycentric, nearest level", view, pyramid, 2, 0);
  AddRank1("rank-1 barycentric, trilinear", view, pyramid, 2, 1);
  const View mesh{ "mesh, ", size, 512 };
  AddPeers(mesh);
  AddRank1("rank-1 barycentric", mesh, texture, 2);
  AddRank1("rank-1 barycentric, trilinear", mesh, pyramid, 2, 1);
  bravais::RatioReporter reporter(
    "million pixels/s", { "VTK linear", "VTK mipmaps", "mesh, VTK linear", "mesh, VTK mipmaps" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return EXIT_SUCCESS;
}
