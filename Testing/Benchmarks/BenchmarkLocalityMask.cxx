// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast a geometry image is culled by its locality masks, beside VTK's filters that cut the same
// frustum out of the same mesh; how fast the hierarchy is made, beside VTK's octree of points; and
// how fast the masks of visible leaves are united, decoded one by one or as Roaring bitmaps.
//
//   BenchmarkLocalityMask [gixels along each axis]...

#include "RatioReporter.h"

#include "BitMask.h"
#include "CullOctree.h"
#include "MaskStore.h"
#include "RoaringCode.h"
#include "RunLengthCode.h"

#include "vtkGeometryImageLocalityMask.h"
#include "vtkGeometryImageSource.h"
#include "vtkGeometryImageToPolyData.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkExtractPolyDataGeometry.h"
#include "vtkExtractSelectedFrustum.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOctreePointLocator.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdlib>

namespace
{

/// Two views of about the same part of the surface, in turn, so that no filter can keep its result.
class Views
{
public:
  Views()
  {
    for (int n = 0; n < 2; ++n)
    {
      vtkNew<vtkCamera> camera;
      camera->SetPosition(2.2, 0.3 + 0.02 * n, 0.7);
      camera->SetFocalPoint(0.5, 0.2, 0.4);
      camera->SetViewAngle(30.0);
      camera->SetClippingRange(0.1, 10.0);
      double equations[24];
      camera->GetFrustumPlanes(1.0, equations);
      this->Frusta[n]->SetFrustumPlanes(equations);
    }
  }
  vtkPlanes* Next() { return this->Frusta[this->Turn = 1 - this->Turn]; }

private:
  vtkNew<vtkPlanes> Frusta[2];
  int Turn = 0;
};

void BenchmarkQueries(vtkImageData* image, vtkPolyData* mesh, int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  benchmark::ClearRegisteredBenchmarks();
  Views views;
  const auto items = static_cast<double>(image->GetNumberOfPoints());
  vtkNew<vtkExtractPolyDataGeometry> geometry;
  geometry->SetInputData(mesh);
  bravais::AddBenchmark("vtkExtractPolyDataGeometry", items,
    [&]
    {
      geometry->SetImplicitFunction(views.Next());
      geometry->Update();
    });
  vtkNew<vtkExtractSelectedFrustum> selected;
  selected->SetInputData(mesh);
  bravais::AddBenchmark("vtkExtractSelectedFrustum", items,
    [&]
    {
      selected->SetFrustum(views.Next());
      selected->Update();
    });
  std::vector<vtkSmartPointer<vtkGeometryImageLocalityMask>> masks;
  for (const int encoding : { 0, 1 })
  {
    for (const bool refine : { false, true })
    {
      for (const int depth : { 4, 5 })
      {
        auto mask = vtkSmartPointer<vtkGeometryImageLocalityMask>::New();
        mask->SetInputData(image);
        mask->SetMaximumDepth(depth);
        mask->SetEncoding(encoding);
        mask->SetRefineToGixels(refine);
        mask->SetCullFunction(views.Next());
        mask->Update();
        masks.push_back(mask);
        const std::string name = std::string("locality mask, ") + mask->GetEncodingAsString() +
          ", depth " + std::to_string(depth) + (refine ? ", refined" : "");
        bravais::AddBenchmark(name, items,
          [mask, &views]
          {
            mask->SetCullFunction(views.Next());
            mask->Update();
          });
      }
    }
  }
  bravais::RatioReporter reporter(
    "Mgixels/s", { "vtkExtractPolyDataGeometry", "vtkExtractSelectedFrustum" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  const double visible = image->GetNumberOfPoints() > 0 ? [&]
  {
    vtkDataArray* mask = masks[1]->GetOutput()->GetPointData()->GetArray("LocalityMask");
    double sum = 0.0;
    for (vtkIdType n = 0; n < mask->GetNumberOfTuples(); ++n)
    {
      sum += mask->GetTuple1(n);
    }
    return sum / items;
  }()
                                                        : 0.0;
  std::printf("%.1f %% of the gixels are visible\n\n", 100.0 * visible);
}

void BenchmarkBuilds(vtkImageData* image, vtkPolyData* mesh)
{
  benchmark::ClearRegisteredBenchmarks();
  const auto items = static_cast<double>(image->GetNumberOfPoints());
  bravais::AddBenchmark("vtkOctreePointLocator", items,
    [&]
    {
      vtkNew<vtkOctreePointLocator> locator;
      locator->SetDataSet(mesh);
      locator->BuildLocator();
    });
  for (const int encoding : { 0, 1 })
  {
    for (const int depth : { 5, 10 })
    {
      bravais::AddBenchmark(std::string("hierarchy and masks, ") + (encoding ? "Roaring" : "RLE") +
          ", depth " + std::to_string(depth),
        items,
        [=]
        {
          vtkNew<vtkGeometryImageLocalityMask> mask;
          mask->SetInputData(image);
          mask->SetMaximumDepth(depth);
          mask->SetEncoding(encoding);
          mask->Update();
        });
    }
  }
  bravais::RatioReporter reporter("Mgixels/s", { "vtkOctreePointLocator" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\n");
}

/// The octree of an image's gixels, without VTK.
struct Hierarchy
{
  Hierarchy(vtkImageData* image, int depth)
    : Gixels(static_cast<std::uint64_t>(image->GetNumberOfPoints()))
  {
    vtkDataArray* points = image->GetPointData()->GetVectors();
    std::vector<glm::dvec3> positions(this->Gixels);
    bravais::Box box{ glm::dvec3(1e300), glm::dvec3(-1e300) };
    for (std::size_t n = 0; n < positions.size(); ++n)
    {
      points->GetTuple(static_cast<vtkIdType>(n), &positions[n].x);
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], positions[n][axis]);
        box.High[axis] = std::max(box.High[axis], positions[n][axis]);
      }
    }
    this->Grid = bravais::CellGrid::CreateRound(box, depth);
    std::vector<std::uint32_t> codes;
    for (const glm::dvec3& position : positions)
    {
      codes.push_back(this->Grid->GetCode(position));
    }
    this->Tree = bravais::GixelOctree(codes, depth);
  }

  bravais::MaskStore Encode(bravais::MaskStore::Encoding encoding) const
  {
    bravais::MaskStore masks(this->Tree, this->Gixels, encoding, true);
    for (int depth = 0; depth <= this->Tree.GetDepth(); ++depth)
    {
      masks.Encode(this->Tree, depth);
    }
    return masks;
  }

  std::uint64_t Gixels;
  std::optional<bravais::CellGrid> Grid;
  bravais::GixelOctree Tree;
};

/// Unites the masks of all leaves that a ball meets, none of which is an inner node's.
void BenchmarkUnions(vtkImageData* image, int depth)
{
  using Encoding = bravais::MaskStore::Encoding;
  const Hierarchy hierarchy(image, depth);
  const bravais::MaskStore runs = hierarchy.Encode(Encoding::RunLength);
  const bravais::MaskStore roaring = hierarchy.Encode(Encoding::Roaring);
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t leaf = 0; leaf < hierarchy.Tree.GetLeaves().GetSize(); ++leaf)
  {
    std::uint64_t pending = 0;
    const bravais::Box box =
      hierarchy.Grid->GetBox(bravais::FromMorton(hierarchy.Tree.GetLeaves().Codes[leaf]), depth);
    if (bravais::SphereTest(glm::dvec3(1.0, 0.3, 0.2), 1.0).Classify(box, pending) !=
      bravais::Overlap::Outside)
    {
      leaves.push_back(leaf);
    }
  }
  std::printf("union of %zu of %zu leaves' masks, depth %d\n", leaves.size(),
    hierarchy.Tree.GetLeaves().GetSize(), depth);

  benchmark::ClearRegisteredBenchmarks();
  const std::size_t size = bravais::GetMaskSize(hierarchy.Gixels);
  std::vector<std::uint8_t> bits(size);
  const auto items = static_cast<double>(leaves.size());
  bravais::AddBenchmark("run lengths decoded, then or", items,
    [&]
    {
      std::fill(bits.begin(), bits.end(), std::uint8_t{ 0 });
      for (const std::uint32_t leaf : leaves)
      {
        const auto code = runs.Get(depth, leaf);
        const auto mask = bravais::DecodeRunLength(
          code.Begin, static_cast<std::size_t>(code.End - code.Begin), size);
        std::transform(mask->begin(), mask->end(), bits.begin(), bits.begin(),
          [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
      }
    });
  bravais::AddBenchmark("run lengths or'ed run by run", items,
    [&]
    {
      std::fill(bits.begin(), bits.end(), std::uint8_t{ 0 });
      for (const std::uint32_t leaf : leaves)
      {
        const auto code = runs.Get(depth, leaf);
        bravais::OrRunLengthCode(code.Begin, code.End, bits.data());
      }
    });
  std::vector<std::uint8_t> values(hierarchy.Gixels);
  for (const auto& [store, name] : { std::pair(&runs, "run lengths"), { &roaring, "Roaring" } })
  {
    const bravais::MaskStore* masks = store;
    bravais::AddBenchmark(std::string(name) + " painted, a byte a gixel", items,
      [&, masks]
      {
        std::fill(values.begin(), values.end(), std::uint8_t{ 0 });
        for (const std::uint32_t leaf : leaves)
        {
          masks->Paint(depth, leaf, values.data());
        }
      });
  }
  bravais::AddBenchmark("Roaring union by CRoaring", items,
    [&]
    {
      bravais::RoaringUnion all;
      for (const std::uint32_t leaf : leaves)
      {
        const auto code = roaring.Get(depth, leaf);
        if (code.Format == Encoding::Roaring)
        {
          all.Add(code.Begin, code.End);
        }
      }
      all.Finish();
    });
  bravais::RatioReporter reporter("Mmasks/s", { "run lengths decoded, then or" });
  benchmark::RunSpecifiedBenchmarks(&reporter);
  std::printf("\n");
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<int> sizes;
  for (int n = 1; n < argc; ++n)
  {
    sizes.push_back(std::atoi(argv[n]));
  }
  if (sizes.empty())
  {
    sizes = { 257, 1025 };
  }
  for (const int size : sizes)
  {
    if (size < 2 || size > 8193)
    {
      std::fprintf(stderr, "usage: %s [gixels along each axis, 2 to 8193]...\n", argv[0]);
      return 1;
    }
    vtkNew<vtkGeometryImageSource> source;
    source->SetShapeToBumpySphere();
    source->SetDimensions(size, size);
    vtkNew<vtkGeometryImageToPolyData> surface;
    surface->SetInputConnection(source->GetOutputPort());
    surface->Update();
    std::printf("%d x %d gixels, %lld triangles\n", size, size,
      static_cast<long long>(surface->GetOutput()->GetNumberOfPolys()));
    int none = 1;
    BenchmarkQueries(source->GetOutput(), surface->GetOutput(), none, argv);
    BenchmarkBuilds(source->GetOutput(), surface->GetOutput());
    BenchmarkUnions(source->GetOutput(), 5);
  }
  return 0;
}
