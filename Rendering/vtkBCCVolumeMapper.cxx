// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeMapper.h"

#include "BCCChecks.h"
#include "BCCPrefilter.h"
#include "vtkBCCCoefficientArray.h"
#include "vtkBCCCoefficientTexels.h"
#include "vtkBCCLattice.h"
#include "vtkBCCVolumeFrame.h"
#include "vtkBCCVolumeShaderStage.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkMultiVolume.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

vtkStandardNewMacro(vtkBCCVolumeMapper);

namespace
{
// What makes 0 to 1 of the colours that four dependent components are, as textures of VTK do.
float GetNormalizer(int scalarType)
{
  switch (scalarType)
  {
    case VTK_UNSIGNED_CHAR:
      return 1.0f / VTK_UNSIGNED_CHAR_MAX;
    case VTK_SIGNED_CHAR:
      return 1.0f / VTK_SIGNED_CHAR_MAX;
    case VTK_UNSIGNED_SHORT:
      return 1.0f / VTK_UNSIGNED_SHORT_MAX;
    case VTK_SHORT:
      return 1.0f / VTK_SHORT_MAX;
    default:
      return 1.0f;
  }
}
}

//------------------------------------------------------------------------------
class vtkBCCVolumeMapper::Internals
{
public:
  // What coefficients are made from; they are made anew when any of it changes.
  using Sources = std::tuple<vtkImageData*, vtkMTimeType, vtkDataArray*, int, int>;

  vtkNew<vtkBCCVolumeShaderStage> Stage;
  vtkNew<vtkImageData> StandIn;
  std::optional<vtkBCCVolumeFrame> Frame;
  vtkBCCCoefficientTexels Texels;
  Sources Loaded;
  vtkTimeStamp LoadTime;
  std::string LastError;
  vtkMTimeType LastErrorTime = 0;

  // Makes coefficients and the image that VTK is shown.
  bool Load(
    vtkImageData* image, vtkDataArray* scalars, const vtkBCCVolumeMapper* mapper, std::string& why);
};

//------------------------------------------------------------------------------
bool vtkBCCVolumeMapper::Internals::Load(
  vtkImageData* image, vtkDataArray* scalars, const vtkBCCVolumeMapper* mapper, std::string& why)
{
  const Sources sources{ image, image->GetMTime(), scalars, mapper->Kernel, mapper->Prefilter };
  if (this->Frame && this->Loaded == sources)
  {
    return true;
  }
  this->Frame.reset();
  vtkNew<vtkBCCCoefficientArray> description;
  if (!description->Describe(scalars))
  {
    why = "A component of the input's scalars has no finite value.";
    return false;
  }
  const vtkBCCVolumeFrame frame(image);
  const auto kernel = static_cast<bravais::BCCKernel>(mapper->Kernel);
  const auto prefilter = static_cast<bravais::BCCPrefilter>(mapper->Prefilter);
  if (!this->Texels.Load(frame, scalars, kernel, prefilter))
  {
    why = std::string("The prefilter ") + bravais::GetName(prefilter) +
      " failed on the input; there may not be enough memory.";
    return false;
  }
  frame.FitStandIn(this->StandIn);
  this->StandIn->GetCellData()->SetScalars(description);
  this->Frame = frame;
  this->Loaded = sources;
  this->LoadTime.Modified();
  return true;
}

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
  os << indent << "IsoSurfaceRefinement: " << (this->IsoSurfaceRefinement ? "On" : "Off") << "\n";
  os << indent << "CoefficientTime: " << this->GetCoefficientTime() << "\n";
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetKernel(int kernel)
{
  if (!bravais::ToBCCKernel(kernel))
  {
    vtkErrorMacro("Kernel " << kernel << " is unknown; it has to be 4, 7, 8 or 12.");
  }
  else if (this->Kernel != kernel)
  {
    this->Kernel = kernel;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeMapper::GetKernelAsString()
{
  return bravais::GetName(static_cast<bravais::BCCKernel>(this->Kernel));
}

//------------------------------------------------------------------------------
void vtkBCCVolumeMapper::SetPrefilter(int prefilter)
{
  if (!bravais::ToBCCPrefilter(prefilter))
  {
    vtkErrorMacro("Prefilter " << prefilter << " is unknown; it has to be 0, 1, 2 or 3.");
  }
  else if (this->Prefilter != prefilter)
  {
    this->Prefilter = prefilter;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeMapper::GetPrefilterAsString()
{
  return bravais::GetName(static_cast<bravais::BCCPrefilter>(this->Prefilter));
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
  return this->Impl->LoadTime.GetMTime();
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
bool vtkBCCVolumeMapper::Prepare(vtkRenderer* renderer, vtkVolume* volume, std::string& why)
{
  if (vtkMultiVolume::SafeDownCast(volume) || this->GetInputCount() > 1)
  {
    why = "There is more than one input; a BCC volume is rendered by itself.";
    return false;
  }
  if (this->UseDepthPass && this->BlendMode == vtkVolumeMapper::COMPOSITE_BLEND)
  {
    why = "UseDepthPass is on; its contours are those of a Cartesian grid, not of a BCC volume.";
    return false;
  }
  if (vtkAlgorithm* source = this->GetInputCount() == 1 ? this->GetInputAlgorithm(0, 0) : nullptr)
  {
    source->Update();
  }
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  int cellFlag = 0;
  vtkDataArray* scalars = image ? vtkAbstractMapper::GetScalars(image, this->ScalarMode,
                                    this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag)
                                : nullptr;
  vtkNew<vtkImageData> view; // the image with the array that is to be rendered
  if (image)
  {
    view->ShallowCopy(image);
    view->GetPointData()->SetScalars(cellFlag == 0 ? scalars : nullptr);
  }
  if (!bravais::CheckBCCImage(image ? view.Get() : nullptr, why))
  {
    return false;
  }
  const int components = scalars->GetNumberOfComponents();
  if (components > 4)
  {
    why = "The input's scalars have " + std::to_string(components) +
      " components; 1 to 4 can be "
      "rendered.";
    return false;
  }
  const auto kernel = static_cast<bravais::BCCKernel>(this->Kernel);
  const auto prefilter = static_cast<bravais::BCCPrefilter>(this->Prefilter);
  if (!bravais::IsDefined(kernel, prefilter))
  {
    why = std::string(bravais::GetName(kernel)) + " has no prefilter " +
      bravais::GetName(prefilter) +
      ": its shifts are linearly dependent, and no spline passes through all samples. BCC4 and "
      "BCC8 "
      "have one.";
    return false;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const glm::ivec3 size = vtkBCCCoefficientTexels::GetSize(vtkBCCVolumeFrame(image));
  window->MakeCurrent();
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (std::max({ size.x, size.y, size.z }) > limit)
  {
    why = "The input needs a texture of " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + " x " + std::to_string(size.z) + " texels; OpenGL takes up to " +
      std::to_string(limit) + " along each axis.";
    return false;
  }
  return this->Impl->Load(image, scalars, this, why);
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
    this->ReportOnce(why);
    return;
  }
  impl.LastError.clear();

  // VTK takes its own copy of an input, unless there is one that is newer than the input.
  vtkDataSet*& shown = this->TransformedInputs[0];
  if (shown != impl.StandIn)
  {
    if (shown)
    {
      shown->Delete();
    }
    shown = impl.StandIn;
    shown->Register(this);
  }
  this->LastInputs[0] = this->GetDataSetInput();

  vtkVolumeProperty* property = volume->GetProperty();
  vtkBCCVolumeShaderStage::Options options;
  options.Kernel = static_cast<bravais::BCCKernel>(this->Kernel);
  options.AnalyticGradients = this->AnalyticGradients;
  options.RefineRoots = this->IsoSurfaceRefinement &&
    this->BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND &&
    property->GetIsoSurfaceValues()->GetNumberOfContours() > 0;
  options.WriteDepth = options.RefineRoots && !vtkBCCVolumeShaderStage::IsDepthTaken(volume);
  options.Components = impl.Texels.Components;
  const bool colors = options.Components == 4 && !property->GetIndependentComponents();
  const auto normalizer =
    colors ? GetNormalizer(std::get<vtkDataArray*>(impl.Loaded)->GetDataType()) : 1.0f;

  const int scalarMode = this->ScalarMode;
  this->ScalarMode = VTK_SCALAR_MODE_DEFAULT; // The stand-in has one array.
  impl.Stage->Begin(renderer, volume, options, *impl.Frame, impl.Texels, normalizer);
  this->Superclass::Render(renderer, volume);
  impl.Stage->End();
  this->ScalarMode = scalarMode;
}
