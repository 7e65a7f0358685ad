// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeometryImageWriter.h"

#include "FloatImageFile.h"
#include "GeometryImage.h"
#include "GimFile.h"

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
  const std::string path = this->FileName;
  if (!vtksys::ofstream(path.c_str(), std::ios::binary))
  {
    why = "The file " + path + " cannot be written.";
    return false;
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  bool written = false;
  if (ending == ".gim")
  {
    written = bravais::WriteGim(path, bravais::GixelView(image), why);
  }
  else if (ending == ".vti")
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->FileName);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    written = writer->Write() != 0;
    why = "The file " + path + " cannot be written.";
  }
  else
  {
    written = bravais::WriteFloatImage(path, bravais::GixelView(image), why);
  }
  if (!written)
  {
    vtksys::SystemTools::RemoveFile(path);
  }
  return written;
}

//------------------------------------------------------------------------------
void vtkGeometryImageWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->UpdateProgress(0.0);
  std::string why;
  if (!this->WriteImage(why))
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
