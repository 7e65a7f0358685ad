// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OIIOMetadata.h"

#include "OIIOChannels.h"

#include <OpenImageIO/strutil.h>

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace bravais
{

namespace
{

/// How a file stored its pixels, or what another header says anyway.
bool IsStorage(const std::string& name)
{
  constexpr const char* names[] = { "channels", "compression", "CompressionQuality", "FileFormat",
    "FileScalarType", "Lattice", "textureformat", "tiles", "version", "planarconfig", "DateTime",
    "ICCProfile", "GeometryImage" };
  constexpr const char* families[] = { "oiio:", "tiff:", "png:", "openexr:", "jpeg:", "bmp:",
    "targa:", "dpx:", "Rank1.", "hdr:", "pnm:", "raw:", "ICCProfile:", "vtk" };
  const auto equal = [&](const char* other) { return name == other; };
  const auto starts = [&](const char* family)
  { return name.compare(0, std::strlen(family), family) == 0; };
  return std::any_of(std::begin(names), std::end(names), equal) ||
    std::any_of(std::begin(families), std::end(families), starts);
}

} // namespace

//------------------------------------------------------------------------------
void AddOIIOMetadata(const OIIO::ImageSpec& spec, vtkFieldData* data)
{
  for (const OIIO::ParamValue& attribute : spec.extra_attribs)
  {
    const OIIO::TypeDesc type = attribute.type();
    const std::string name = attribute.name().string();
    const std::size_t count = type.numelements();
    if (type.basetype == OIIO::TypeDesc::STRING)
    {
      vtkNew<vtkStringArray> array;
      array->SetName(name.c_str());
      const auto* values = static_cast<const char* const*>(attribute.data());
      for (std::size_t index = 0; index < count; ++index)
      {
        array->InsertNextValue(values[index] ? values[index] : "");
      }
      data->AddArray(array);
      continue;
    }
    const OIIO::TypeDesc base(static_cast<OIIO::TypeDesc::BASETYPE>(type.basetype));
    const int own = base == OIIO::TypeDesc::HALF ? VTK_VOID : ToVTKType(base);
    if (own != VTK_VOID)
    {
      vtkSmartPointer<vtkDataArray> array;
      array.TakeReference(vtkDataArray::CreateDataArray(own));
      array->SetName(name.c_str());
      array->SetNumberOfComponents(std::max<int>(1, type.aggregate));
      array->SetNumberOfTuples(static_cast<vtkIdType>(count));
      std::memcpy(array->GetVoidPointer(0), attribute.data(), type.size());
      data->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
void SetOIIOMetadata(vtkFieldData* data, OIIO::ImageSpec& spec)
{
  for (int index = 0; index < data->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* array = data->GetAbstractArray(index);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name.empty() || IsStorage(name) || array->GetNumberOfValues() < 1)
    {
      continue;
    }
    auto* strings = vtkStringArray::SafeDownCast(array);
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (strings && strings->GetNumberOfValues() == 1)
    {
      spec.attribute(name, strings->GetValue(0));
    }
    else if (numbers && numbers->HasStandardMemoryLayout() && numbers->GetNumberOfValues() <= 64)
    {
      OIIO::TypeDesc type = FromVTKType(numbers->GetDataType());
      type.arraylen =
        numbers->GetNumberOfValues() > 1 ? static_cast<int>(numbers->GetNumberOfValues()) : 0;
      if (type.basetype != OIIO::TypeDesc::UNKNOWN)
      {
        spec.attribute(name, type, numbers->GetVoidPointer(0));
      }
    }
  }
}

} // namespace bravais
