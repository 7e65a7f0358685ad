// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageLocalityMask.h"

#include "BitMask.h"
#include "CullVolume.h"
#include "GeometryHierarchy.h"
#include "GeometryImage.h"
#include "LocalityQuery.h"
#include "PieceRequest.h"
#include "RoaringCode.h"
#include "RunLengthCode.h"
#include "TriangleSearch.h"

#include "vtkCamera.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

vtkStandardNewMacro(vtkGeometryImageLocalityMask);

namespace
{
/// The share of progress that is the hierarchy's, where it is made.
constexpr double BuildShare = 0.9;

bool CheckLine(vtkObject* algorithm, const double p1[3], const double p2[3])
{
  const bool finite = std::all_of(p1, p1 + 3, [](double x) { return std::isfinite(x); }) &&
    std::all_of(p2, p2 + 3, [](double x) { return std::isfinite(x); });
  if (!finite)
  {
    vtkErrorWithObjectMacro(algorithm,
      "The line is from (" << p1[0] << ", " << p1[1] << ", " << p1[2] << ") to (" << p2[0] << ", "
                           << p2[1] << ", " << p2[2] << "); finite points were expected.");
  }
  return finite;
}

bool CheckArray(vtkObject* algorithm, vtkDataArray* array)
{
  if (!array)
  {
    vtkErrorWithObjectMacro(algorithm, "There is no array; one to write to was expected.");
  }
  return array != nullptr;
}
}

//------------------------------------------------------------------------------
class vtkGeometryImageLocalityMask::Internals
{
public:
  bravais::GeometryHierarchy Hierarchy;
  vtkTimeStamp HierarchyTime;
  bravais::GeometryHierarchy Other; // of the image at port 1
  bravais::LocalityQuery Query;
  vtkSmartPointer<vtkUnsignedCharArray> Mask;       // of the last query
  vtkSmartPointer<vtkImageData> Image;              // the input as it then was
  std::vector<std::uint32_t> LeafOrder;             // leaves by cell, made when it is asked for
  std::unique_ptr<bravais::TriangleSearch> Surface; // likewise

  void Forget()
  {
    this->Hierarchy.Clear();
    this->ForgetQuery();
  }
  void ForgetQuery()
  {
    this->Query = bravais::LocalityQuery();
    this->Mask = nullptr;
    this->Image = nullptr;
    this->LeafOrder.clear();
    this->Surface.reset();
  }
  const std::vector<std::uint32_t>& GetLeafOrder()
  {
    if (this->LeafOrder.empty() && !this->Hierarchy.IsEmpty())
    {
      this->LeafOrder = this->Hierarchy.GetTree().GetLeavesByCell();
    }
    return this->LeafOrder;
  }

  /// What the query is of; it has no test where there is neither function nor camera.
  static bool MakeVolume(
    vtkGeometryImageLocalityMask* self, bravais::CullVolume& volume, std::string& why)
  {
    if (self->CullFunction)
    {
      return bravais::MakeCullVolume(self->CullFunction, volume, why);
    }
    return !self->Camera || bravais::MakeCullVolume(self->Camera, self->AspectRatio, volume, why);
  }

  bravais::GeometryHierarchy::Parameters GetParameters(vtkGeometryImageLocalityMask* self) const
  {
    const double* cube = self->RootCube;
    return { self->MaximumDepth, { cube[0], cube[1], cube[2], cube[3] },
      self->Encoding == RLE ? bravais::MaskStore::Encoding::RunLength
                            : bravais::MaskStore::Encoding::Roaring,
      self->StoreInternalMasks };
  }

  /// Makes the hierarchy anew if it is not the input's. Progress then is `share`, and so is done.
  bool BuildHierarchy(vtkGeometryImageLocalityMask* self, vtkImageData* input, double share,
    double& done, std::string& why)
  {
    const bravais::GeometryHierarchy::Parameters parameters = this->GetParameters(self);
    if (this->Hierarchy.IsOf(input, parameters))
    {
      return true;
    }
    this->ForgetQuery();
    done = share;
    if (!this->Hierarchy.Build(self, input, parameters, 0.0, done, why))
    {
      return false;
    }
    this->HierarchyTime.Modified();
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->ShallowCopy(input);
    return true;
  }

  /// The same for the other image, whose leaves the volume will be.
  bool BuildOther(vtkGeometryImageLocalityMask* self, vtkImageData* image, double& done,
    bravais::CullVolume& volume, std::string& why)
  {
    bravais::GeometryHierarchy::Parameters parameters = this->GetParameters(self);
    std::fill_n(parameters.RootCube, 4, 0.0);
    if (!this->Other.IsOf(image, parameters))
    {
      if (!this->Other.Build(self, image, parameters, done, BuildShare, why))
      {
        return false;
      }
      done = BuildShare;
    }
    volume.Test = this->Other.GetGrid()
      ? std::unique_ptr<bravais::VolumeTest>(
          std::make_unique<bravais::LeavesTest>(this->Other.GetTree(), *this->Other.GetGrid()))
      : std::make_unique<bravais::PlanesTest>(std::vector<bravais::PlanesTest::Plane>(1));
    return true;
  }
};

//------------------------------------------------------------------------------
vtkGeometryImageLocalityMask::vtkGeometryImageLocalityMask()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkGeometryImageLocalityMask::~vtkGeometryImageLocalityMask() = default;

//------------------------------------------------------------------------------
const char* vtkGeometryImageLocalityMask::GetEncodingAsString()
{
  return this->Encoding == RLE ? "RLE" : "Roaring";
}

//------------------------------------------------------------------------------
void vtkGeometryImageLocalityMask::SetCullFunction(vtkImplicitFunction* function)
{
  if (this->CullFunction != function)
  {
    this->CullFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkGeometryImageLocalityMask::GetCullFunction()
{
  return this->CullFunction;
}

//------------------------------------------------------------------------------
void vtkGeometryImageLocalityMask::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkGeometryImageLocalityMask::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeometryImageLocalityMask::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = std::max(time, this->CullFunction ? this->CullFunction->GetMTime() : 0);
  return std::max(time, this->Camera ? this->Camera->GetMTime() : 0);
}

//------------------------------------------------------------------------------
int vtkGeometryImageLocalityMask::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeometryImageLocalityMask::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  bravais::CullVolume volume;
  std::string why;
  if (!bravais::GeometryHierarchy::Check(this->Internal->GetParameters(this), why) ||
    !Internals::MakeVolume(this, volume, why))
  {
    vtkErrorMacro(<< why);
    this->Internal->Forget();
    bravais::RefuseInformation(outputVector);
    return 0;
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkGeometryImageLocalityMask::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    if (info && info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      bravais::RequestWholeExtent(info);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeometryImageLocalityMask::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* other = vtkImageData::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(info);
  Internals& own = *this->Internal;
  const auto stop = [&](const std::string& why)
  {
    own.Forget();
    output->Initialize();
    if (!why.empty())
    {
      vtkErrorMacro(<< why);
      return 0;
    }
    return 1; // aborted
  };
  std::string why;
  if (!bravais::CheckGeometryImage(input, why) ||
    (other && !bravais::CheckGeometryImage(other, why)))
  {
    return stop(why);
  }
  bravais::CullVolume volume;
  if (!Internals::MakeVolume(this, volume, why))
  {
    return stop(why);
  }

  double done = 0.0;
  if (!own.BuildHierarchy(this, input, other ? 0.5 * BuildShare : BuildShare, done, why))
  {
    return stop(why);
  }
  if (other && !this->CullFunction && !this->Camera &&
    !own.BuildOther(this, other, done, volume, why))
  {
    return stop(why.empty() ? why : "At input port 1: " + why);
  }

  const bravais::GixelView gixels(input);
  const vtkIdType size = gixels.GetNumberOfGixels();
  auto mask = vtkSmartPointer<vtkUnsignedCharArray>::New();
  mask->SetName("LocalityMask");
  mask->SetNumberOfValues(size);
  std::memset(mask->GetPointer(0), 0, static_cast<std::size_t>(size));
  if (!own.Query.Execute(
        this, own.Hierarchy, gixels, volume, this->RefineToGixels, done, mask->GetPointer(0)))
  {
    return stop("");
  }
  own.Mask = mask;
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(mask);
  int extent[6];
  bravais::GetPieceExtent(info, extent);
  if (!std::equal(extent, extent + 6, output->GetExtent()))
  {
    output->Crop(extent);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetNumberOfNodes()
{
  return static_cast<vtkIdType>(this->Internal->Hierarchy.GetTree().GetNumberOfNodes());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetNumberOfLeaves()
{
  const bravais::GeometryHierarchy& hierarchy = this->Internal->Hierarchy;
  return hierarchy.IsEmpty() ? 0
                             : static_cast<vtkIdType>(hierarchy.GetTree().GetLeaves().GetSize());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetNumberOfVisibleLeaves()
{
  return static_cast<vtkIdType>(this->Internal->Query.GetNumberOfLeaves());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetUncompressedSize(bool leavesOnly)
{
  return static_cast<vtkIdType>(
    this->Internal->Hierarchy.GetMasks().GetUncompressedSize(leavesOnly));
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetCompressedSize(bool leavesOnly)
{
  return static_cast<vtkIdType>(this->Internal->Hierarchy.GetMasks().GetSize(leavesOnly));
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetNumberOfExceptions()
{
  const bravais::MaskStore& masks = this->Internal->Hierarchy.GetMasks();
  return static_cast<vtkIdType>(masks.GetNumberOfExceptions());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetVisibleSize()
{
  const Internals& own = *this->Internal;
  return own.Hierarchy.IsEmpty() ? 0 : static_cast<vtkIdType>(own.Query.GetSize(own.Hierarchy));
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::GetUnionSize()
{
  vtkUnsignedCharArray* mask = this->Internal->Mask;
  if (!mask)
  {
    return 0;
  }
  const auto size = static_cast<std::uint64_t>(mask->GetNumberOfValues());
  const std::vector<std::uint8_t> bits = bravais::PackBits(mask->GetPointer(0), size);
  std::vector<std::uint8_t> code;
  bravais::AppendRunLengthCode(bits.data(), bits.size(), code);
  std::size_t smallest = code.size();
  if (this->Encoding == Roaring)
  {
    std::vector<std::uint32_t> places;
    for (std::uint32_t gixel = 0; gixel < size; ++gixel)
    {
      if (mask->GetValue(gixel))
      {
        places.push_back(gixel);
      }
    }
    code.clear();
    bravais::AppendRoaringCode(places.data(), places.size(), code);
    smallest = std::min(smallest, code.size());
  }
  return static_cast<vtkIdType>(smallest);
}

//------------------------------------------------------------------------------
double vtkGeometryImageLocalityMask::GetCullTime()
{
  return this->Internal->Query.GetCullTime();
}

//------------------------------------------------------------------------------
double vtkGeometryImageLocalityMask::GetUnionTime()
{
  return this->Internal->Query.GetUnionTime();
}

//------------------------------------------------------------------------------
bool vtkGeometryImageLocalityMask::GetLeafMask(vtkIdType leaf, vtkUnsignedCharArray* mask)
{
  if (!CheckArray(this, mask))
  {
    return false;
  }
  Internals& own = *this->Internal;
  mask->SetNumberOfComponents(1);
  if (leaf < 0 || leaf >= this->GetNumberOfLeaves())
  {
    mask->SetNumberOfTuples(0);
    vtkErrorMacro(<< "Leaf " << leaf << " was asked for; there are " << this->GetNumberOfLeaves()
                  << ".");
    return false;
  }
  const bravais::GeometryHierarchy& hierarchy = own.Hierarchy;
  mask->SetNumberOfTuples(hierarchy.GetNumberOfGixels());
  mask->FillValue(0);
  hierarchy.GetMasks().Paint(hierarchy.GetTree().GetDepth(),
    own.GetLeafOrder()[static_cast<std::size_t>(leaf)], mask->GetPointer(0));
  mask->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkGeometryImageLocalityMask::GetLeafCode(vtkIdType leaf, vtkUnsignedCharArray* code)
{
  if (!CheckArray(this, code))
  {
    return false;
  }
  code->SetNumberOfComponents(1);
  code->SetNumberOfTuples(0);
  if (this->GetLeafEncoding(leaf) < 0)
  {
    vtkErrorMacro(<< "Leaf " << leaf << " was asked for; there are " << this->GetNumberOfLeaves()
                  << ".");
    return false;
  }
  const bravais::GeometryHierarchy& hierarchy = this->Internal->Hierarchy;
  const bravais::MaskStore::Code kept = hierarchy.GetMasks().Get(
    hierarchy.GetTree().GetDepth(), this->Internal->GetLeafOrder()[static_cast<std::size_t>(leaf)]);
  code->SetNumberOfTuples(kept.End - kept.Begin);
  std::copy(kept.Begin, kept.End, code->GetPointer(0));
  code->Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkGeometryImageLocalityMask::GetLeafEncoding(vtkIdType leaf)
{
  if (leaf < 0 || leaf >= this->GetNumberOfLeaves())
  {
    return -1;
  }
  const bravais::GeometryHierarchy& hierarchy = this->Internal->Hierarchy;
  const bravais::MaskStore::Code kept = hierarchy.GetMasks().Get(
    hierarchy.GetTree().GetDepth(), this->Internal->GetLeafOrder()[static_cast<std::size_t>(leaf)]);
  return kept.Format == bravais::MaskStore::Encoding::RunLength ? RLE : Roaring;
}

//------------------------------------------------------------------------------
void vtkGeometryImageLocalityMask::GetLeafCells(vtkIdTypeArray* cells)
{
  if (!CheckArray(this, cells))
  {
    return;
  }
  cells->Initialize();
  cells->SetNumberOfComponents(3);
  for (const std::uint32_t leaf : this->Internal->GetLeafOrder())
  {
    const auto cell =
      bravais::FromMorton(this->Internal->Hierarchy.GetTree().GetLeaves().Codes[leaf]);
    const double tuple[3] = { static_cast<double>(cell.x), static_cast<double>(cell.y),
      static_cast<double>(cell.z) };
    cells->InsertNextTuple(tuple);
  }
}

//------------------------------------------------------------------------------
bool vtkGeometryImageLocalityMask::IntersectWithLine(
  const double p1[3], const double p2[3], double& t, double x[3], vtkIdType gixels[3])
{
  if (!CheckLine(this, p1, p2))
  {
    return false;
  }
  Internals& own = *this->Internal;
  this->Update();
  if (!own.Hierarchy.GetGrid() || !own.Image)
  {
    return false;
  }
  const bravais::GixelView view(own.Image);
  const bravais::TriangleSearch::Positions positions = [&](std::uint32_t gixel)
  {
    glm::dvec3 point;
    view.GetPoint(gixel, &point.x);
    return point;
  };
  if (!own.Surface)
  {
    own.Surface = std::make_unique<bravais::TriangleSearch>(own.Hierarchy.GetTree(),
      static_cast<std::uint32_t>(view.GetWidth()), static_cast<std::uint32_t>(view.GetHeight()),
      positions);
  }
  const auto hit = own.Surface->Intersect(
    glm::dvec3(p1[0], p1[1], p1[2]), glm::dvec3(p2[0], p2[1], p2[2]), positions);
  if (!hit)
  {
    return false;
  }
  t = hit->Parameter;
  for (int n = 0; n < 3; ++n)
  {
    x[n] = hit->Point[n];
    gixels[n] = hit->Gixels[static_cast<std::size_t>(n)];
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeometryImageLocalityMask::IntersectWithLine(
  const double p1[3], const double p2[3], vtkUnsignedCharArray* mask)
{
  if (!CheckArray(this, mask) || !CheckLine(this, p1, p2))
  {
    return 0;
  }
  this->Update();
  const bravais::GeometryHierarchy& hierarchy = this->Internal->Hierarchy;
  mask->SetNumberOfComponents(1);
  mask->SetNumberOfTuples(hierarchy.GetNumberOfGixels());
  mask->FillValue(0);
  mask->Modified();
  if (!hierarchy.GetGrid())
  {
    return 0;
  }
  const bravais::SegmentTest line(glm::dvec3(p1[0], p1[1], p1[2]), glm::dvec3(p2[0], p2[1], p2[2]));
  bravais::CullResult result;
  bravais::CullOctree(hierarchy.GetTree(), *hierarchy.GetGrid(), line, result);
  for (const std::uint32_t leaf : result.Partly)
  {
    hierarchy.GetMasks().Paint(hierarchy.GetTree().GetDepth(), leaf, mask->GetPointer(0));
  }
  return static_cast<vtkIdType>(result.Partly.size());
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeometryImageLocalityMask::GetHierarchyMTime()
{
  return this->Internal->HierarchyTime.GetMTime();
}

//------------------------------------------------------------------------------
void vtkGeometryImageLocalityMask::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* cube = this->RootCube;
  os << indent << "MaximumDepth: " << this->MaximumDepth << "\n";
  os << indent << "RootCube: (" << cube[0] << ", " << cube[1] << ", " << cube[2] << ", " << cube[3]
     << ")\n";
  os << indent << "Encoding: " << this->GetEncodingAsString() << "\n";
  os << indent << "StoreInternalMasks: " << (this->StoreInternalMasks ? "on" : "off") << "\n";
  os << indent << "RefineToGixels: " << (this->RefineToGixels ? "on" : "off") << "\n";
  os << indent << "CullFunction: " << this->CullFunction.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "AspectRatio: " << this->AspectRatio << "\n";
}
