// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
// The lattice tag survives what VTK does to an image, and other data are not taken for BCC.

#include "vtkBCCLattice.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <cstdlib>

#define CHECK(condition)                                                                           \
  if (!(condition))                                                                                \
  {                                                                                                \
    vtkLog(ERROR, "Not so: " #condition);                                                          \
    return EXIT_FAILURE;                                                                           \
  }

int TestBCCLatticeTag(int, char*[])
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 3, 4);
  image->AllocateScalars(VTK_FLOAT, 1);
  CHECK(!vtkBCCLattice::IsBCC(nullptr));
  CHECK(!vtkBCCLattice::IsBCC(image));
  vtkBCCLattice::Tag(image);
  CHECK(vtkBCCLattice::IsBCC(image));

  vtkNew<vtkImageData> copy;
  copy->ShallowCopy(image);
  CHECK(vtkBCCLattice::IsBCC(copy));

  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->WriteToOutputStringOn();
  CHECK(writer->Write() == 1);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  CHECK(vtkBCCLattice::IsBCC(reader->GetOutput()));

  vtkNew<vtkStringArray> other;
  other->SetName("Lattice");
  other->InsertNextValue("Rank1");
  copy->GetFieldData()->Initialize();
  copy->GetFieldData()->AddArray(other);
  CHECK(!vtkBCCLattice::IsBCC(copy));

  vtkNew<vtkPolyData> mesh;
  mesh->GetFieldData()->AddArray(image->GetFieldData()->GetAbstractArray("Lattice"));
  CHECK(!vtkBCCLattice::IsBCC(mesh));
  return EXIT_SUCCESS;
}
