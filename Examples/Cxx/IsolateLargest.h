// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef IsolateLargest_h
#define IsolateLargest_h

/// \file
/// One object of a volume without what lies about it, such as a head without its head rest.

#include "vtkSmartPointer.h"

class vtkImageData;

/// The volume with its lowest value everywhere but in the largest connected region above the
/// threshold and within two samples of it. Null after an error.
vtkSmartPointer<vtkImageData> IsolateLargest(vtkImageData* image, double threshold);

#endif
