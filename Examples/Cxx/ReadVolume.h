// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadVolume_h
#define ReadVolume_h

/// \file
/// Volumes from files.

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

/// The volume of a .vti, .mhd, .mha, .nii, .nii.gz, .nrrd, .nhdr or legacy .vtk file: three
/// dimensions and one scalar a point. Null, with a sentence that names the file, if there is none.
vtkSmartPointer<vtkImageData> ReadVolume(const std::string& path, std::string& why);

#endif
