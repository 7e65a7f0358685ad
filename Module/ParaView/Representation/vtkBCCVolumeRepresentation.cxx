// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeRepresentation.h"

#include "vtkBCCLattice.h"
#include "vtkBCCVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPolyDataMapper.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkBCCVolumeRepresentation);

//------------------------------------------------------------------------------
vtkBCCVolumeRepresentation::vtkBCCVolumeRepresentation()
{
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
  this->GetMapper()->SetKernel(kernel);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetPrefilter(int method)
{
  this->GetMapper()->SetPrefilter(method);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeRepresentation::SetSampleDistance(double distance)
{
  this->GetMapper()->SetAutoAdjustSampleDistances(distance <= 0.0);
  this->GetMapper()->SetLockSampleDistanceToInputSpacing(distance <= 0.0);
  if (distance > 0.0)
  {
    this->GetMapper()->SetSampleDistance(static_cast<float>(distance));
  }
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
    vtkBCCLattice::GetBox(cache, this->DataBounds);
    this->OutlineSource->SetBounds(this->DataBounds);
    this->OutlineSource->Update();
    this->DataSize = cache->GetActualMemorySize();
    vtkStreamingDemandDrivenPipeline::GetWholeExtent(
      inputVector[0]->GetInformationObject(0), this->WholeExtent);
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
