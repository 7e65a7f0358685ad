// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageSource.h"

#include "GeometryImage.h"
#include "ImageChecks.h"
#include "ParametricSurface.h"
#include "SliceLoop.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkGeometryImageSource);

//------------------------------------------------------------------------------
vtkGeometryImageSource::vtkGeometryImageSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
const char* vtkGeometryImageSource::GetShapeAsString()
{
  static const char* const names[] = { "Sphere", "Torus", "BumpySphere", "Plane" };
  return names[this->Shape];
}

//------------------------------------------------------------------------------
const char* vtkGeometryImageSource::GetOutputScalarTypeAsString()
{
  return vtkImageScalarTypeNameMacro(this->OutputScalarType);
}

//------------------------------------------------------------------------------
bool vtkGeometryImageSource::CheckParameters(std::string& why) const
{
  const auto check = [&](const char* name, double value, bool positive)
  {
    if (std::isfinite(value) && (!positive || value > 0.0))
    {
      return true;
    }
    std::ostringstream text;
    text << name << " is " << value << "; a finite number" << (positive ? " above 0" : "")
         << " was expected.";
    why = text.str();
    return false;
  };
  const int* n = this->Dimensions;
  if (n[0] < 1 || n[1] < 1)
  {
    std::ostringstream text;
    text << "Dimensions are " << n[0] << ", " << n[1] << "; at least 1, 1 are needed.";
    why = text.str();
    return false;
  }
  const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, 0 };
  const bool bumpy = this->Shape == BumpySphere;
  return bravais::CheckExtent(
           whole, 3 * vtkDataArray::GetDataTypeSize(this->OutputScalarType), why) &&
    check("Center", this->Center[0] + this->Center[1] + this->Center[2], false) &&
    check("Radius", this->Radius, true) &&
    (this->Shape != Torus || check("CrossSectionRadius", this->CrossSectionRadius, true)) &&
    (!bumpy || check("BumpAmplitude", this->BumpAmplitude, false)) &&
    (!bumpy || check("BumpFrequency", this->BumpFrequency, false));
}

//------------------------------------------------------------------------------
int vtkGeometryImageSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  std::string why;
  if (!this->CheckParameters(why))
  {
    vtkErrorMacro(<< why);
    vtkImageData::GetData(outputVector)->Initialize();
    return 0;
  }
  const int whole[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0, 0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  info->Set(vtkDataObject::SPACING(), 1.0, 1.0, 1.0);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkGeometryImageSource::GetPoint(int i, int j, double x[3]) const
{
  const int* n = this->Dimensions;
  const glm::dvec2 uv(
    bravais::GetSymmetricParameter(i, n[0]), bravais::GetSymmetricParameter(j, n[1]));
  glm::dvec3 point(this->Radius * uv, 0.0);
  if (this->Shape == Torus)
  {
    // The last grid line is the first again.
    const glm::dvec2 turns(n[0] > 1 ? static_cast<double>(i % (n[0] - 1)) / (n[0] - 1) : 0.0,
      n[1] > 1 ? static_cast<double>(j % (n[1] - 1)) / (n[1] - 1) : 0.0);
    point = bravais::GetTorusPoint(turns, this->Radius, this->CrossSectionRadius);
  }
  else if (this->Shape != Plane)
  {
    const glm::dvec3 direction = bravais::FoldSphere(uv);
    const double radius = this->Shape == Sphere
      ? 1.0
      : bravais::GetBumpyRadius(direction, this->BumpAmplitude, this->BumpFrequency);
    point = this->Radius * radius * direction;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    x[axis] = this->Center[axis] + point[axis];
  }
}

//------------------------------------------------------------------------------
int vtkGeometryImageSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    bravais::TagGeometryImage(output);
    return 1; // a piece without gixels
  }
  std::string why;
  if (!bravais::CheckMemory(extent, 3 * vtkDataArray::GetDataTypeSize(this->OutputScalarType), why))
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  }
  output->SetExtent(extent);
  auto points =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->OutputScalarType));
  points->SetName(bravais::GeometryImagePoints);
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(output->GetNumberOfPoints());
  const vtkIdType columns = vtkIdType{ extent[1] } - extent[0] + 1;
  const auto fill = [&](auto* values)
  {
    using T = std::remove_reference_t<decltype(*values)>;
    const auto row = [&](int j)
    {
      T* out = values + 3 * columns * (j - extent[2]);
      for (int i = extent[0]; i <= extent[1]; ++i, out += 3)
      {
        double x[3];
        this->GetPoint(i, j, x);
        for (int axis = 0; axis < 3; ++axis)
        {
          out[axis] = static_cast<T>(x[axis]);
        }
      }
    };
    return bravais::ForEachSlice(this, extent[2], extent[3], row);
  };
  void* values = points->GetVoidPointer(0);
  if (!(this->OutputScalarType == VTK_FLOAT ? fill(static_cast<float*>(values))
                                            : fill(static_cast<double*>(values))))
  {
    output->Initialize();
    return 1;
  }
  output->GetPointData()->SetVectors(points);
  bravais::TagGeometryImage(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkGeometryImageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* c = this->Center;
  os << indent << "Shape: " << this->GetShapeAsString() << "\n";
  os << indent << "Dimensions: (" << this->Dimensions[0] << ", " << this->Dimensions[1] << ")\n";
  os << indent << "Center: (" << c[0] << ", " << c[1] << ", " << c[2] << ")\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "CrossSectionRadius: " << this->CrossSectionRadius << "\n";
  os << indent << "BumpAmplitude: " << this->BumpAmplitude << "\n";
  os << indent << "BumpFrequency: " << this->BumpFrequency << "\n";
  os << indent << "OutputScalarType: " << this->GetOutputScalarTypeAsString() << "\n";
}
