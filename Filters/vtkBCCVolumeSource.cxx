// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumeSource.h"

#include "AnalyticSignals.h"
#include "BCCLattice.h"
#include "ImageChecks.h"
#include "SliceLoop.h"
#include "vtkBCCLattice.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkBCCVolumeSource);

namespace
{
/// Values of value(x) at all points of an image, whose origin and spacing are set.
template <class T, class F>
bool Fill(vtkAlgorithm* self, vtkImageData* image, bool parallel, const F& value)
{
  int e[6];
  image->GetExtent(e);
  const double* o = image->GetOrigin();
  const double* s = image->GetSpacing();
  T* values = static_cast<T*>(image->GetScalarPointer());
  const auto layer = [&](int k)
  {
    const double half = 0.5 * bravais::BCCLattice::GetCoset(k);
    T* out = values + static_cast<vtkIdType>(k - e[4]) * (e[3] - e[2] + 1) * (e[1] - e[0] + 1);
    glm::dvec3 x(0.0, 0.0, o[2] + s[2] * k);
    for (int j = e[2]; j <= e[3]; ++j)
    {
      x.y = o[1] + s[1] * (j + half);
      for (int i = e[0]; i <= e[1]; ++i)
      {
        x.x = o[0] + s[0] * (i + half);
        *out++ = static_cast<T>(value(x));
      }
    }
  };
  return parallel ? bravais::ForEachSlice(self, e[4], e[5], layer)
                  : bravais::ForEachSliceInOrder(self, e[4], e[5], layer);
}
}

//------------------------------------------------------------------------------
vtkBCCVolumeSource::vtkBCCVolumeSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkBCCVolumeSource::~vtkBCCVolumeSource() = default;

//------------------------------------------------------------------------------
void vtkBCCVolumeSource::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkBCCVolumeSource::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkBCCVolumeSource::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeSource::GetFunctionAsString()
{
  static const char* const names[] = { "MarschnerLobb", "Sphere", "Gaussian", "Constant" };
  return names[this->Function];
}

//------------------------------------------------------------------------------
const char* vtkBCCVolumeSource::GetOutputScalarTypeAsString()
{
  return vtkImageScalarTypeNameMacro(this->OutputScalarType);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeSource::CheckGeometry(std::string& why) const
{
  const int* n = this->Dimensions;
  if (n[0] < 1 || n[1] < 1 || n[2] < 2)
  {
    std::ostringstream text;
    text << "Dimensions are " << n[0] << ", " << n[1] << ", " << n[2]
         << "; at least 1, 1, 2 are needed.";
    why = text.str();
    return false;
  }
  const double* b = this->Bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(b[2 * axis] < b[2 * axis + 1]) || !std::isfinite(b[2 * axis + 1] - b[2 * axis]))
    {
      std::ostringstream text;
      text << "Bounds along "
           << "xyz"[axis] << " are " << b[2 * axis] << ", " << b[2 * axis + 1]
           << "; two finite numbers in ascending order were expected.";
      why = text.str();
      return false;
    }
  }
  const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  return bravais::CheckExtent(whole, vtkDataArray::GetDataTypeSize(this->OutputScalarType), why);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumeSource::CheckFunction(std::string& why) const
{
  const auto check = [&](const char* name, double parameter, double above)
  {
    if (std::isfinite(parameter) && parameter > above)
    {
      return true;
    }
    std::ostringstream text;
    text << name << " is " << parameter << "; a finite number";
    if (std::isfinite(above))
    {
      text << " above " << above;
    }
    text << " was expected.";
    why = text.str();
    return false;
  };
  if (this->ImplicitFunction || this->Function == Sphere)
  {
    return true;
  }
  if (this->Function == MarschnerLobb)
  {
    return check("Alpha", this->Alpha, -1.0) && check("Frequency", this->Frequency, -INFINITY);
  }
  return this->Function == Gaussian ? check("StandardDeviation", this->StandardDeviation, 0.0)
                                    : check("Value", this->Value, -INFINITY);
}

//------------------------------------------------------------------------------
int vtkBCCVolumeSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  std::string why;
  if (!this->CheckGeometry(why) || !this->CheckFunction(why))
  {
    vtkErrorMacro(<< why);
    vtkImageData::GetData(outputVector)->Initialize();
    return 0;
  }
  const int* n = this->Dimensions;
  const double* b = this->Bounds;
  const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  const double origin[3] = { b[0], b[2], b[4] };
  const double spacing[3] = { (b[1] - b[0]) / (n[0] - 0.5), (b[3] - b[2]) / (n[1] - 0.5),
    (b[5] - b[4]) / (n[2] - 1) };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->OutputScalarType, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBCCVolumeSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  vtkBCCLattice::Tag(output);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece without points
  }
  std::string why;
  if (!bravais::CheckMemory(extent, vtkDataArray::GetDataTypeSize(this->OutputScalarType), why))
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  output->SetExtent(extent);
  output->AllocateScalars(this->OutputScalarType, 1);
  output->GetPointData()->GetScalars()->SetName("Scalars");
  const bool finished = this->OutputScalarType == VTK_FLOAT ? this->Sample<float>(output)
                                                            : this->Sample<double>(output);
  if (!finished)
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
template <class T>
bool vtkBCCVolumeSource::Sample(vtkImageData* output)
{
  const double* b = this->Bounds;
  const glm::dvec3 center = 0.5 * glm::dvec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
  if (vtkImplicitFunction* function = this->ImplicitFunction)
  {
    return Fill<T>(this, output, false,
      [=](const glm::dvec3& x) { return function->FunctionValue(x.x, x.y, x.z); });
  }
  switch (this->Function)
  {
    case Sphere:
      return Fill<T>(
        this, output, true, [=](const glm::dvec3& x) { return glm::distance(x, center); });
    case Gaussian:
      return Fill<T>(this, output, true,
        [=](const glm::dvec3& x)
        { return bravais::Gaussian(x - center, this->StandardDeviation); });
    case Constant:
      return Fill<T>(this, output, true, [=](const glm::dvec3&) { return this->Value; });
    default:
      return Fill<T>(this, output, true,
        [=](const glm::dvec3& x)
        { return bravais::MarschnerLobb(x, this->Alpha, this->Frequency); });
  }
}

//------------------------------------------------------------------------------
void vtkBCCVolumeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->Dimensions;
  const double* b = this->Bounds;
  os << indent << "Dimensions: (" << n[0] << ", " << n[1] << ", " << n[2] << ")\n";
  os << indent << "Bounds: (" << b[0] << ", " << b[1] << ", " << b[2] << ", " << b[3] << ", "
     << b[4] << ", " << b[5] << ")\n";
  os << indent << "Function: " << this->GetFunctionAsString() << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "StandardDeviation: " << this->StandardDeviation << "\n";
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "OutputScalarType: " << this->GetOutputScalarTypeAsString() << "\n";
}
