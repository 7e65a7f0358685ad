// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery.h"

#include "CommandLine.h"
#include "ErrorLog.h"

#include "vtkBCCLattice.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkImageShrink3D.h"

#include <vtksys/SystemTools.hxx>

#include <cstdio>
#include <iostream>

Gallery::Gallery(const std::string& folder, int size, int total)
  : Folder(folder)
  , Total(total)
  , Stage(size, size, true)
{
  vtksys::SystemTools::MakeDirectory(folder);
}

void Gallery::Say(const std::string& text)
{
  std::cout << text << std::endl;
}

bool Gallery::Write(vtkImageData* picture, const std::string& name, std::string& why)
{
  const std::string path = this->Folder + "/" + name + ".png";
  if (WritePicture(picture, path))
  {
    return true;
  }
  why = path + ": cannot be written";
  return false;
}

vtkSmartPointer<vtkImageData> Gallery::Draw(const Drawing& drawing, std::string& why)
{
  const bool bcc = vtkBCCLattice::IsBCC(drawing.Volume);
  PictureRow row;
  row.Picture = drawing.Name;
  row.Kernel = bcc ? NameOfKernel(drawing.Kernel) : "trilinear";
  row.Prefilter = bcc ? NameOfPrefilter(drawing.Prefilter) : "";
  row.Samples = drawing.Volume->GetNumberOfPoints();
  row.Error = drawing.Error;
  std::printf("[%2d/%d] %s ... ", ++this->Count, this->Total, drawing.Name.c_str());
  std::fflush(stdout);
  this->Stage.Show(
    drawing.Volume, drawing.How, drawing.Surfaces, drawing.Kernel, drawing.Prefilter);
  this->Stage.LookFrom(drawing.Look);
  const std::string label = row.Kernel + (bcc ? ", " + row.Prefilter : "");
  this->Stage.SetLabel(drawing.Label.empty() ? label : drawing.Label);
  row.Seconds = this->Stage.Time();
  std::printf("%.2f s a frame\n", row.Seconds);
  std::fflush(stdout);
  vtkSmartPointer<vtkImageData> picture = this->Stage.Grab();
  why = ErrorLog::TakeFirstError();
  if (!why.empty() || !this->Write(picture, drawing.Name, why))
  {
    return nullptr;
  }
  this->Table.Add(row);
  vtkNew<vtkImageData> kept;
  kept->DeepCopy(picture);
  return kept;
}

bool Gallery::WriteMontage(const std::string& name,
  const std::vector<vtkSmartPointer<vtkImageData>>& pictures, int columns, int shrink,
  std::string& why)
{
  vtkNew<vtkImageAppend> rows;
  rows->SetAppendAxis(1);
  const std::size_t step = static_cast<std::size_t>(columns);
  // Rows are counted from the bottom in VTK.
  for (std::size_t end = pictures.size(); end >= step; end -= step)
  {
    vtkNew<vtkImageAppend> row;
    for (std::size_t p = end - step; p < end; ++p)
    {
      vtkNew<vtkImageShrink3D> small;
      small->SetInputData(pictures[p]);
      small->SetShrinkFactors(shrink, shrink, 1);
      small->MeanOn();
      row->AddInputConnection(small->GetOutputPort());
    }
    rows->AddInputConnection(row->GetOutputPort());
  }
  rows->Update();
  return this->Write(rows->GetOutput(), name, why);
}
