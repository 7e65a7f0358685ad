// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeRepresentation.h"

#include "vtkBCCLattice.h"
#include "vtkBCCVolumeMapper.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkExtentTranslator.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkBCCVolumeRepresentation);

namespace
{
int GetNumberOfProcesses()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller ? controller->GetNumberOfProcesses() : 1;
}

// The extent that an image has without its ghost cells.
void GetOwnExtent(vtkImageData* image, int extent[6])
{
  image->GetExtent(extent);
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    image->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts || image->GetNumberOfCells() == 0)
  {
    return;
  }
  const auto isGhost = [](unsigned char flags)
  { return (flags & vtkDataSetAttributes::DUPLICATECELL) != 0; };
  const unsigned char* begin = ghosts->GetPointer(0);
  const unsigned char* end = begin + ghosts->GetNumberOfValues();
  const auto first = std::find_if_not(begin, end, isGhost) - begin;
  const auto last =
    std::find_if_not(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), isGhost)
      .base() -
    begin - 1;
  if (first > last)
  {
    std::fill_n(extent, 6, 0);
    extent[1] = extent[3] = extent[5] = -1; // Every cell is another's.
    return;
  }
  int cells[3];
  image->GetDimensions(cells);
  std::for_each(cells, cells + 3, [](int& count) { count = std::max(count - 1, 1); });
  const std::ptrdiff_t ends[2] = { first, last };
  for (int side = 0; side < 2; ++side)
  {
    const int place[3] = { static_cast<int>(ends[side] % cells[0]),
      static_cast<int>(ends[side] / cells[0] % cells[1]),
      static_cast<int>(ends[side] / cells[0] / cells[1]) };
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + side] = image->GetExtent()[2 * axis] + place[axis] + side;
    }
  }
}
}

//------------------------------------------------------------------------------
vtkBCCVolumeRepresentation::vtkBCCVolumeRepresentation()
{
  vtkMath::UninitializeBounds(this->WholeBounds);
  this->VolumeMapper.TakeReference(vtkBCCVolumeMapper::New());
}

//------------------------------------------------------------------------------
vtkBCCVolumeRepresentation::~vtkBCCVolumeRepresentation() = default;

//------------------------------------------------------------------------------
vtkBCCVolumeMapper* vtkBCCVolumeRepresentation::GetMapper()
{
  return vtkBCCVolumeMapper::SafeDownCast(this->VolumeMapper);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetKernel(int kernel)
{
  this->Kernel = kernel;
  this->Ask();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetPrefilter(int method)
{
  this->Prefilter = method;
  this->Ask();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetSampleDistance(double distance)
{
  this->SampleDistance = distance;
  this->Ask();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetBlendMode(int mode)
{
  this->BlendMode = mode;
  this->Ask();
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeRepresentation::IsBlendable() const
{
  return this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
    this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND ||
    this->BlendMode == vtkVolumeMapper::SLICE_BLEND;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeRepresentation::NeedsWhole() const
{
  return !this->IsBlendable() || this->Prefilter > 1;
}

//------------------------------------------------------------------------------
// Tells the mapper, and has another piece asked for if this one does not do any more.
void vtkBCCVolumeRepresentation::Ask()
{
  vtkBCCVolumeMapper* mapper = this->GetMapper();
  const double unit[3] = { 1.0, 1.0, 1.0 };
  const auto find = [&]
  {
    return std::make_tuple(
      mapper->GetNumberOfGhostLevels(unit), mapper->GetPrefilter() > 1, mapper->GetBlendMode());
  };
  const auto before = find();
  mapper->SetKernel(this->Kernel);
  mapper->SetPrefilter(this->Prefilter);
  mapper->SetBlendMode(this->BlendMode);
  mapper->SetAutoAdjustSampleDistances(this->SampleDistance <= 0.0);
  mapper->SetLockSampleDistanceToInputSpacing(this->SampleDistance <= 0.0);
  if (this->SampleDistance > 0.0)
  {
    mapper->SetSampleDistance(static_cast<float>(this->SampleDistance));
  }
  if (GetNumberOfProcesses() > 1 && find() != before)
  {
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
int vtkBCCVolumeRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (GetNumberOfProcesses() < 2 || inputVector[0]->GetNumberOfInformationObjects() != 1)
  {
    return 1;
  }
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (this->NeedsWhole())
  {
    int whole[6];
    Pipeline::GetWholeExtent(info, whole);
    info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  }
  else
  {
    double spacing[3] = { 1.0, 1.0, 1.0 };
    if (info->Has(vtkDataObject::SPACING()))
    {
      info->Get(vtkDataObject::SPACING(), spacing);
    }
    const double* scale = this->Actor->GetScale();
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      this->GetMapper()->GetNumberOfGhostLevels(
        spacing, std::max({ scale[0], scale[1], scale[2], 1.0 })));
  }
  return 1;
}

//------------------------------------------------------------------------------
// What of the volume this process shows.
void vtkBCCVolumeRepresentation::MarkPiece(vtkImageData* cache, const int whole[6])
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int process = controller->GetLocalProcessId();
  int own[6] = { 0, -1, 0, -1, 0, -1 };
  if (!this->IsBlendable())
  {
    if (process == 0)
    {
      std::copy_n(whole, 6, own);
    }
  }
  else if (this->NeedsWhole())
  {
    int all[6];
    std::copy_n(whole, 6, all);
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(
      process, controller->GetNumberOfProcesses(), 0, all, own, vtkExtentTranslator::BLOCK_MODE, 0);
  }
  else
  {
    GetOwnExtent(cache, own);
  }
  vtkBCCLattice::MarkPiece(cache, whole, own);
}

//------------------------------------------------------------------------------
// Collects what the other processes have of ranges and of the box; all of them have to call it.
void vtkBCCVolumeRepresentation::ShareRanges(vtkImageData* cache)
{
  vtkMultiProcessStream mine;
  mine.Push(this->DataBounds, 6);
  vtkPointData* data = cache->GetPointData();
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* array = data->GetArray(n);
    const int components = array && array->GetName() ? array->GetNumberOfComponents() : 0;
    for (int component = 0; component < std::min(components, 4); ++component)
    {
      double range[2];
      array->GetFiniteRange(range, component);
      mine << std::string(array->GetName()) << component << range[0] << range[1];
    }
  }
  std::vector<vtkMultiProcessStream> all;
  vtkMultiProcessController::GetGlobalController()->AllGather(mine, all);
  vtkBoundingBox box;
  for (vtkMultiProcessStream& stream : all)
  {
    double bounds[6];
    unsigned int size = 6;
    double* place = bounds;
    stream.Pop(place, size);
    box.AddBounds(bounds);
    while (!stream.Empty())
    {
      std::string name;
      int component;
      double range[2];
      double known[2];
      stream >> name >> component >> range[0] >> range[1];
      if (vtkBCCLattice::GetWholeRange(cache, name.c_str(), component, known))
      {
        range[0] = std::min(range[0], known[0]);
        range[1] = std::max(range[1], known[1]);
      }
      vtkBCCLattice::MarkWholeRange(cache, name.c_str(), component, range);
    }
  }
  box.GetBounds(this->WholeBounds);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::UpdateMapperParameters()
{
  // VTK's cropping planes are those of the whole box.
  double bounds[6];
  std::copy_n(this->DataBounds, 6, bounds);
  std::copy_n(this->WholeBounds, 6, this->DataBounds);
  this->Superclass::UpdateMapperParameters();
  std::copy_n(bounds, 6, this->DataBounds);
}

//------------------------------------------------------------------------------
int vtkBCCVolumeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkImageData::GetData(inputVector[0], 0)
    : nullptr;
  vtkNew<vtkImageData> cache;
  this->Cache = cache.GetPointer();
  vtkMath::UninitializeBounds(this->DataBounds);
  if (input)
  {
    cache->ShallowCopy(input);
    this->Actor->SetEnableLOD(0);
    vtkStreamingDemandDrivenPipeline::GetWholeExtent(
      inputVector[0]->GetInformationObject(0), this->WholeExtent);
    if (GetNumberOfProcesses() > 1)
    {
      vtkNew<vtkFieldData> fields; // of its own, to be marked
      fields->ShallowCopy(input->GetFieldData());
      cache->SetFieldData(fields);
      this->MarkPiece(cache, this->WholeExtent);
      cache->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      cache->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
    vtkBCCLattice::GetBox(cache, this->DataBounds);
    std::copy_n(this->DataBounds, 6, this->WholeBounds);
    if (GetNumberOfProcesses() > 1)
    {
      this->ShareRanges(cache);
    }
    this->OutlineSource->SetBounds(this->DataBounds);
    this->OutlineSource->Update();
    this->DataSize = cache->GetActualMemorySize();
  }
  else
  {
    // A process without data, as a client: it shows the outline that is delivered to it.
    this->DataSize = 0;
    this->VolumeMapper->RemoveAllInputs();
    this->Actor->SetEnableLOD(1);
  }
  // What vtkImageVolumeRepresentation would do is done.
  return this->vtkVolumeRepresentation::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}
