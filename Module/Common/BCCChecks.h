// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCChecks_h
#define BCCChecks_h

/// \file
/// What every filter asks before it starts. A check that fails returns false and sets `why` to a
/// sentence that names the value and what was expected, ready for vtkErrorMacro.

#include <string>

class vtkImageData;

namespace bravais
{

/// Whether a number is that of a scalar type images have: VTK_CHAR to VTK_DOUBLE, of 8 to 64 bits.
bool IsNumberType(int type);

/// Whether an image's spacing is positive and finite, and its origin finite.
bool CheckPlacement(const double origin[3], const double spacing[3], std::string& why);

/// Whether an image can be read as a BCC volume: tagged, at least one point along x and y and two
/// layers, a positive and finite spacing, a finite origin, and point scalars that are numbers. The
/// extent that is judged is `whole`, or the image's own where that is nullptr.
bool CheckBCCImage(vtkImageData* image, const int whole[6], std::string& why);
bool CheckBCCImage(vtkImageData* image, std::string& why);

/// Whether an extent is not empty, its indices and lattice coordinates fit int, and its points of
/// so many bytes can be counted.
bool CheckExtent(const int extent[6], int bytesPerPoint, std::string& why);

/// Whether an array of that extent fits the machine's memory. Implies CheckExtent.
bool CheckMemory(const int extent[6], int bytesPerPoint, std::string& why);

} // namespace bravais

#endif
