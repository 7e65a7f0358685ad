// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageWriter.h"

#include "FloatImageFile.h"
#include "GeometryImage.h"
#include "GimFile.h"

#include <OpenImageIO/filesystem.h>

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLImageDataWriter.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

vtkStandardNewMacro(vtkGeometryImageWriter);

//------------------------------------------------------------------------------
bool vtkGeometryImageWriter::WriteImage(std::string& why)
{
  if (!this->FileName || !*this->FileName)
  {
    why = "There is no FileName; that of a .gim, .vti or float image file was expected.";
    return false;
  }
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    why = "There is no input; a geometry image was expected.";
    return false;
  }
  this->GetInputAlgorithm()->UpdateWholeExtent();
  vtkImageData* image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!bravais::CheckGeometryImage(image, why))
  {
    return false;
  }
  // Under another name of the same ending, until it is complete: an older file stays otherwise.
  const std::string path = this->FileName;
  std::string ending = vtksys::SystemTools::GetFilenameLastExtension(path);
  const std::string part = path.substr(0, path.size() - ending.size()) + ".part" + ending;
  if (vtksys::SystemTools::FileIsDirectory(path) ||
    !vtksys::ofstream(part.c_str(), std::ios::binary))
  {
    why = "The file " + path + " cannot be written.";
    return false;
  }
  ending = vtksys::SystemTools::LowerCase(ending);
  bool written = false;
  if (ending == ".gim")
  {
    written = bravais::WriteGim(part, bravais::GixelView(image), why);
  }
  else if (ending == ".vti")
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(part.c_str());
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    written = writer->Write() != 0;
    why = "The file " + path + " cannot be written.";
  }
  else
  {
    written = bravais::WriteFloatImage(part, bravais::GixelView(image), why);
  }
  vtksys::SystemTools::ReplaceString(why, part, path);
  this->UpdateProgress(0.9);
  if (written && !this->GetAbortExecute())
  {
    std::string error;
    written = OIIO::Filesystem::rename(part, path, error);
    why = "The file " + path + " cannot be written: " + error + ".";
  }
  vtksys::SystemTools::RemoveFile(part); // what is left of it
  return written;
}

//------------------------------------------------------------------------------
void vtkGeometryImageWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->SetAbortExecute(0);
  this->UpdateProgress(0.0);
  std::string why;
  if (!this->GetAbortExecute() && !this->WriteImage(why))
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< why);
    return;
  }
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
void vtkGeometryImageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
