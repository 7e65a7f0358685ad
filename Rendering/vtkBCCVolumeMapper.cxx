// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeMapper.h"

#include "BCCChecks.h"
#include "BCCCoefficients.h"
#include "BCCPrefilter.h"
#include "vtkBCCLattice.h"
#include "vtkBCCMaskLabels.h"
#include "vtkBCCPieceSampling.h"
#include "vtkBCCProgress.h"
#include "vtkBCCProgressiveFrame.h"
#include "vtkBCCRenderChecks.h"
#include "vtkBCCVolumeInput.h"
#include "vtkBCCVolumeMask.h"
#include "vtkBCCVolumePiece.h"
#include "vtkBCCVolumeShaderStage.h"
#include "vtkBCCVolumeShaderText.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

vtkStandardNewMacro(vtkBCCVolumeMapper);

namespace
{
// What JitterPattern may be.
enum
{
  NoJitter,
  VTKJitter,
  BayerJitter
};

// Of an image, or of all that it is a piece of.
vtkBCCVolumeFrame GetWholeFrame(vtkImageData* image)
{
  int whole[6];
  int piece[6];
  return vtkBCCLattice::GetPiece(image, whole, piece) ? vtkBCCVolumeFrame(image, whole)
                                                      : vtkBCCVolumeFrame(image);
}
}

//------------------------------------------------------------------------------
class vtkBCCVolumeMapper::Internals
{
public:
  vtkBCCVolumeInput Input;
  vtkNew<vtkBCCVolumeShaderStage> Stage;
  bool HasLabels = false;
  vtkBCCMaskLabels Labels;
  bool Independent = true; // components, as last rendered
  int Components = 0;
  vtkBCCProgress Progress;
  std::string LastError;
  vtkMTimeType LastErrorTime = 0;
};

//------------------------------------------------------------------------------
vtkBCCVolumeMapper::vtkBCCVolumeMapper()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkBCCVolumeMapper::~vtkBCCVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << this->GetKernelAsString() << "\n";
  os << indent << "Prefilter: " << this->GetPrefilterAsString() << "\n";
  os << indent << "AnalyticGradients: " << (this->AnalyticGradients ? "On" : "Off") << "\n";
  os << indent << "EmptySpaceSkipping: " << (this->EmptySpaceSkipping ? "On" : "Off") << "\n";
  os << indent << "HalfFloatCoefficients: " << (this->HalfFloatCoefficients ? "On" : "Off") << "\n";
  os << indent << "CoefficientError: " << this->GetCoefficientError() << "\n";
  os << indent << "IsoSurfaceRefinement: " << (this->IsoSurfaceRefinement ? "On" : "Off") << "\n";
  os << indent << "JitterPattern: " << this->GetJitterPatternAsString() << "\n";
  os << indent << "ProgressiveRefinement: " << (this->ProgressiveRefinement ? "On" : "Off") << "\n";
  os << indent << "ProgressivePatternSize: " << this->ProgressivePatternSize << "\n";
  os << indent << "ProgressComplete: " << (this->GetProgressComplete() ? "Yes" : "No") << "\n";
  os << indent << "CoefficientTime: " << this->GetCoefficientTime() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeMapper::GetKernelAsString()
{
  const auto kernel = bravais::ToBCCKernel(this->Kernel);
  return kernel ? bravais::GetName(*kernel) : "Unknown";
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeMapper::GetPrefilterAsString()
{
  const auto prefilter = bravais::ToBCCPrefilter(this->Prefilter);
  return prefilter ? bravais::GetName(*prefilter) : "Unknown";
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetJitterPattern(int pattern)
{
  if (this->JitterPattern != pattern)
  {
    this->JitterPattern = pattern;
    this->UseJittering = pattern == VTKJitter;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeMapper::GetJitterPatternAsString()
{
  static const char* const names[] = { "None", "VTK", "Bayer" };
  const bool known = this->JitterPattern >= NoJitter && this->JitterPattern <= BayerJitter;
  return known ? names[this->JitterPattern] : "Unknown";
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetUseJittering(vtkTypeBool use)
{
  if ((use != 0) != (this->JitterPattern == VTKJitter))
  {
    this->SetJitterPattern(use ? VTKJitter : NoJitter);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::AddBayerJitter(vtkShaderProperty* property)
{
  if (property)
  {
    property->AddFragmentShaderReplacement(vtkBCCVolumeShaderText::JitterStatement, false,
      vtkBCCVolumeShaderText::GetBayerJitter(), true);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::RemoveBayerJitter(vtkShaderProperty* property)
{
  if (property)
  {
    property->ClearFragmentShaderReplacement(vtkBCCVolumeShaderText::JitterStatement, false);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetPartitions(unsigned short x, unsigned short y, unsigned short z)
{
  if (x > 1 || y > 1 || z > 1)
  {
    vtkErrorMacro("Partitions (" << x << ", " << y << ", " << z
                                 << ") were asked for; a BCC volume cannot be cut into them.");
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkBCCVolumeMapper::GetCoefficientTime() const
{
  return this->Impl->Input.LoadTime.GetMTime();
}

//------------------------------------------------------------------------------
double vtkBCCVolumeMapper::GetCoefficientError() const
{
  return this->Impl->Input.CoefficientError;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetMaxMemoryInBytes(vtkIdType bytes)
{
  this->MemoryIsLimited = true;
  this->Superclass::SetMaxMemoryInBytes(bytes);
}

//------------------------------------------------------------------------------
vtkIdType vtkBCCVolumeMapper::GetCoefficientMemory() const
{
  const vtkBCCCoefficientTexels& texels = this->Impl->Input.Texels;
  return texels.GetCount() * (this->HalfFloatCoefficients ? 2 : 4);
}

//------------------------------------------------------------------------------
vtkIdType vtkBCCVolumeMapper::GetBrickMemory() const
{
  return this->Impl->Stage->GetBrickMemory();
}

//------------------------------------------------------------------------------
double* vtkBCCVolumeMapper::GetBounds()
{
  this->Superclass::GetBounds(); // brings the input up to date
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (vtkBCCLattice::IsBCC(image))
  {
    vtkBCCLattice::GetBox(image, this->Bounds);
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkBCCVolumeMapper::GetNumberOfGhostLevels(const double spacing[3], double scale)
{
  return vtkBCCPieceSampling::GetNumberOfGhostLevels(this, spacing, scale);
}

//------------------------------------------------------------------------------
// The sample distance that VTK would take for the whole's stand-in, but for what it adds to save
// time.
float vtkBCCVolumeMapper::FindSampleDistance(const vtkBCCVolumeFrame& frame, vtkVolume* volume)
{
  double spacing[3];
  int extent[6];
  std::copy_n(frame.Spacing, 3, spacing);
  frame.GetStandInExtent(extent);
  return vtkBCCPieceSampling::FindDistance(
    this, spacing, volume->GetMatrix(), this->SpacingAdjustedSampleDistance(spacing, extent));
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::CheckPiece(vtkVolume* volume, vtkImageData* image, std::string& why)
{
  int whole[6];
  int piece[6];
  int reach[3] = { 0, 0, 0 };
  if (vtkBCCLattice::GetPiece(image, whole, piece))
  {
    const vtkBCCVolumeFrame frame = GetWholeFrame(image);
    vtkBCCPieceSampling::FindReach(this, frame.LatticePerUnit,
      this->FindSampleDistance(frame, volume), this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND,
      reach);
  }
  return this->Impl->Input.SetReach(this->Kernel, this->Prefilter, reach, why);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::Prepare(vtkRenderer* renderer, vtkVolume* volume, std::string& why)
{
  if (!vtkBCCRenderChecks::Check(this, volume, why) ||
    !vtkBCCRenderChecks::CheckPatterns(this->JitterPattern, this->ProgressivePatternSize, why))
  {
    return false;
  }
  if (vtkAlgorithm* source = this->GetInputCount() == 1 ? this->GetInputAlgorithm(0, 0) : nullptr)
  {
    source->Update();
  }
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (image && vtkBCCVolumePiece(image, this->Prefilter).IsEmpty())
  {
    return false; // with nothing to tell
  }
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  scalars = cellFlag == 0 ? scalars : nullptr;
  vtkBCCVolumeInput& input = this->Impl->Input;
  if (!input.SetSource(image, scalars, why))
  {
    if (!scalars && this->ScalarMode >= VTK_SCALAR_MODE_USE_POINT_FIELD_DATA)
    {
      why += this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME
        ? " Selected is the array " + std::string(this->ArrayName ? this->ArrayName : "") + "."
        : " Selected is the array number " + std::to_string(this->ArrayId) + ".";
    }
    return false;
  }
  if (!bravais::CheckBCCSpline(this->Kernel, this->Prefilter, why) ||
    !vtkBCCRenderChecks::CheckSampleDistances(
      renderer, this, this->FindSampleDistance(GetWholeFrame(image), volume), why) ||
    !vtkBCCRenderChecks::CheckShading(renderer, volume, scalars->GetNumberOfComponents(), why) ||
    !vtkBCCVolumeMask::Check(this, volume->GetProperty(), scalars->GetNumberOfComponents(), why) ||
    !this->CheckPiece(volume, image, why))
  {
    return false;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  window->MakeCurrent();
  const double bytes = this->MemoryIsLimited
    ? static_cast<double>(this->MaxMemoryInBytes) * this->MaxMemoryFraction
    : std::numeric_limits<double>::infinity();
  return input.CheckTexture(vtkTextureObject::GetMaximumTextureSize3D(window), bytes,
           this->HalfFloatCoefficients, why) &&
    input.Load(this->Kernel, this->Prefilter, this->HalfFloatCoefficients, why);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::ReportOnce(const std::string& why)
{
  vtkDataObject* input = this->GetDataObjectInput();
  const vtkMTimeType time = std::max(this->GetMTime(), input ? input->GetMTime() : 0);
  if (this->Impl->LastError != why || this->Impl->LastErrorTime != time)
  {
    this->Impl->LastError = why;
    this->Impl->LastErrorTime = time;
    vtkErrorMacro(<< why);
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::Update()
{
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    std::string why;
    bravais::CheckBCCImage(nullptr, why);
    this->ReportOnce(why); // The pipeline would report it for every frame.
    return;
  }
  this->Superclass::Update();
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::GetProgressComplete() const
{
  return this->Impl->Progress.IsComplete();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Progress.Release();
  this->Impl->Stage->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::IsShown(vtkRenderer* renderer) const
{
  return !renderer->GetSelector() && !this->RenderToImage && !this->GeneratingCanonicalView;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::IsTracedInPasses(vtkRenderer* renderer, vtkVolume* volume) const
{
  return this->ProgressiveRefinement && this->IsShown(renderer) &&
    this->ImageSampleDistance == 1.0f && !vtkBCCShaderOptions::IsDepthTaken(volume);
}

//------------------------------------------------------------------------------
vtkBCCProgressiveFrame* vtkBCCVolumeMapper::StartPass(
  vtkRenderer* renderer, vtkVolume* volume, bool depth)
{
  // VTK adjusts sample distances to the time that the last frame took, if it took any.
  this->TimeToDraw = 0.0;
  this->ReductionFactor = 1.0;

  return this->Impl->Progress.StartPass(renderer, volume, this, depth);
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::FinishPass(
  vtkRenderer* renderer, vtkVolume* volume, vtkBCCProgressiveFrame* frame)
{
  const auto drawBox = [&](vtkShaderProgram* program)
  {
    this->DoGPURender(renderer, vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera()), program,
      vtkOpenGLShaderProperty::SafeDownCast(volume->GetShaderProperty()));
  };
  const bool complete = !frame || frame->Finish(drawBox);
  if (renderer->GetSelector() || this->GeneratingCanonicalView)
  {
    return; // It is no picture that anybody waits for.
  }
  if (!this->ProgressiveRefinement)
  {
    this->Impl->Progress.Release();
  }
  if (this->Impl->Progress.Finish(renderer, volume, complete) && frame)
  {
    this->InvokeEvent(ProgressCompleteEvent);
  }
}

//------------------------------------------------------------------------------
// VTK would take sample distances from a stand-in that is not divided into cells, and the time.
void vtkBCCVolumeMapper::RenderPiece(vtkRenderer* renderer, vtkVolume* volume)
{
  const vtkBCCVolumeFrame& frame = *this->Impl->Input.Frame;
  const auto kept = std::make_tuple(
    this->AutoAdjustSampleDistances, this->LockSampleDistanceToInputSpacing, this->SampleDistance);
  this->SampleDistance = this->FindSampleDistance(frame, volume);
  this->AutoAdjustSampleDistances = 0;
  this->LockSampleDistanceToInputSpacing = 0;
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    selector->UpdateMaximumCellId(this->GetInput()->GetNumberOfPoints());
    selector->UpdateMaximumPointId(this->GetInput()->GetNumberOfPoints());
  }
  this->Superclass::Render(renderer, volume);
  std::tie(this->AutoAdjustSampleDistances, this->LockSampleDistanceToInputSpacing,
    this->SampleDistance) = kept;
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::ShowStandIn(vtkRenderer* renderer, vtkVolume* volume)
{
  Internals& impl = *this->Impl;
  // VTK takes its own copy of an input, unless there is one that is newer than the input.
  vtkDataSet*& shown = this->TransformedInputs[0];
  if (shown != impl.Input.StandIn)
  {
    if (shown)
    {
      shown->Delete();
    }
    shown = impl.Input.StandIn;
    shown->Register(this);
  }
  // VTK makes the tables of a label map, and those of components that are no more independent or
  // have become so, or more than before, together with its other resources only.
  const bool labels = this->MaskInput && this->MaskType == LabelMapMaskType;
  const bool independent = volume->GetProperty()->GetIndependentComponents() != 0;
  const int components = impl.Input.Texels.Components;
  if ((labels && !impl.HasLabels) || independent != impl.Independent ||
    (impl.Components > 0 && components != impl.Components))
  {
    this->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
  if (labels)
  {
    vtkBCCVolumeMask::NoticeFunctions(volume->GetProperty());
  }
  impl.HasLabels = labels;
  impl.Independent = independent;
  impl.Components = components;
  this->LastInputs[0] = this->GetDataSetInput();
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (!renderer || !volume)
  {
    this->Superclass::Render(renderer, volume); // reports it
    return;
  }
  Internals& impl = *this->Impl;
  std::string why;
  if (!this->Prepare(renderer, volume, why))
  {
    if (!why.empty())
    {
      this->ReportOnce(why);
    }
    return;
  }

  vtkImageData* mask = this->MaskInput;
  const bool used = vtkBCCVolumeMask::IsUsed(this, impl.Input.Texels.Components);
  this->MaskInput = used ? impl.Labels.GetLoadable(mask) : nullptr;
  this->ShowStandIn(renderer, volume);
  auto options = vtkBCCShaderOptions::Collect(this, renderer, volume, impl.Input);
  options.BayerJitter = this->JitterPattern == BayerJitter;
  options.Progressive = this->IsTracedInPasses(renderer, volume);

  const int scalarMode = this->ScalarMode;
  this->ScalarMode = VTK_SCALAR_MODE_DEFAULT; // The stand-in has one array.
  impl.Stage->Begin(renderer, volume, options, impl.Input);
  vtkBCCProgressiveFrame* frame =
    options.Progressive ? this->StartPass(renderer, volume, options.WriteDepth) : nullptr;
  impl.Stage->SetTarget(frame);
  // VTK takes part in selections of cells only, and would spoil those of points by its colours.
  vtkHardwareSelector* selector = renderer->GetSelector();
  const int field = selector ? selector->GetFieldAssociation() : 0;
  if (selector)
  {
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  }
  if (options.Piece)
  {
    this->RenderPiece(renderer, volume);
  }
  else
  {
    this->Superclass::Render(renderer, volume);
  }
  if (selector)
  {
    selector->SetFieldAssociation(field);
  }
  impl.Stage->End();
  this->FinishPass(renderer, volume, frame);
  this->ScalarMode = scalarMode;
  this->MaskInput = mask;

  if (impl.Stage->GetShaderLog().empty())
  {
    impl.LastError.clear();
  }
  else
  {
    this->ReportOnce("The shader does not compile: " + impl.Stage->GetShaderLog());
  }
}
