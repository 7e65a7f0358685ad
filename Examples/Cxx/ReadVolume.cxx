// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReadVolume.h"

#include "ErrorLog.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

#include <vtksys/SystemTools.hxx>

#include <iostream>
#include <sstream>

namespace
{

using vtksys::SystemTools;

vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path)
{
  const std::string name = SystemTools::LowerCase(SystemTools::GetFilenameName(path));
  const auto endsIn = [&name](const char* ending)
  { return SystemTools::StringEndsWith(name, ending); };
  const auto open = [&path](auto* reader)
  {
    reader->SetFileName(path.c_str());
    return vtkSmartPointer<vtkAlgorithm>(reader);
  };
  if (endsIn(".vti"))
  {
    return open(vtkNew<vtkXMLImageDataReader>().Get());
  }
  if (endsIn(".mhd") || endsIn(".mha"))
  {
    return open(vtkNew<vtkMetaImageReader>().Get());
  }
  if (endsIn(".nii") || endsIn(".nii.gz"))
  {
    return open(vtkNew<vtkNIFTIImageReader>().Get());
  }
  if (endsIn(".nrrd") || endsIn(".nhdr"))
  {
    return open(vtkNew<vtkNrrdReader>().Get());
  }
  if (endsIn(".vtk"))
  {
    return open(vtkNew<vtkStructuredPointsReader>().Get());
  }
  return nullptr;
}

/// Reads, and returns what was wrong; empty if all went well. Some readers only warn of a file that
/// ends too early, and MetaIO writes to the error stream.
std::string Update(vtkAlgorithm* reader)
{
  ErrorLog::TakeFirstError();
  ErrorLog::TakeFirstWarning();
  std::ostringstream complaints;
  std::streambuf* const former = std::cerr.rdbuf(complaints.rdbuf());
  reader->Update();
  std::cerr.rdbuf(former);
  const std::string error = ErrorLog::TakeFirstError();
  const std::string warning = ErrorLog::TakeFirstWarning() + complaints.str();
  for (const char* sign : { "Error reading", "failed", "not read completely" })
  {
    if (error.empty() && warning.find(sign) != std::string::npos)
    {
      return "is truncated or damaged";
    }
  }
  return error;
}

/// Why an image is no volume; empty if it is one.
std::string CheckVolume(vtkImageData* image)
{
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return "holds no volume";
  }
  int n[3];
  image->GetDimensions(n);
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    return "has " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " +
      std::to_string(n[2]) + " points; a volume has at least 2 along each axis";
  }
  vtkPointData* data = image->GetPointData();
  if (!data->GetScalars() && data->GetNumberOfArrays() > 0)
  {
    data->SetActiveScalars(data->GetArrayName(0));
  }
  vtkDataArray* scalars = data->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    return "has no values at its points";
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    return "has " + std::to_string(scalars->GetNumberOfComponents()) +
      " values a point; expected one";
  }
  return {};
}

} // namespace

vtkSmartPointer<vtkImageData> ReadVolume(const std::string& path, std::string& why)
{
  if (!SystemTools::FileExists(path, true))
  {
    why = path + ": there is no such file";
    return nullptr;
  }
  const vtkSmartPointer<vtkAlgorithm> reader = MakeReader(path);
  if (!reader)
  {
    why = path +
      ": unknown type; expected .vti, .mhd, .mha, .nii, .nii.gz, .nrrd, .nhdr or legacy .vtk";
    return nullptr;
  }
  why = Update(reader);
  vtkSmartPointer<vtkImageData> image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (why.empty())
  {
    why = CheckVolume(image);
  }
  if (!why.empty())
  {
    why = path + ": " + why;
    return nullptr;
  }
  return image;
}
