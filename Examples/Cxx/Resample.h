// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Resample_h
#define Resample_h

/// \file
/// One volume on two lattices, with as many samples and by equally good resampling.

#include "vtkSmartPointer.h"

class vtkImageData;

/// The volume on an isotropic BCC lattice with about ratio times its samples; the volume itself if
/// it is on a BCC lattice already. Null after an error.
vtkSmartPointer<vtkImageData> ResampleToBCC(vtkImageData* image, double ratio);

/// The volume on an isotropic Cartesian grid with about that many samples, in its own box:
/// low-passed to the new grid and interpolated by a windowed sinc of twelve points along each axis.
vtkSmartPointer<vtkImageData> ResampleToCartesian(vtkImageData* image, vtkIdType samples);

#endif
