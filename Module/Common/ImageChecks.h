// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageChecks_h
#define ImageChecks_h

/// \file
/// What filters of any kind of image ask before they start. A check that fails returns false and
/// sets `why` to a sentence that names the value and what was expected, ready for vtkErrorMacro.

#include "vtkBravaisABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// "nx x ny x nz", in 64 bits: an extent of all of int has more than int's points.
std::string JoinDimensions(const int extent[6]);

/// Whether a number is that of a scalar type images have: VTK_CHAR to VTK_DOUBLE, of 8 to 64 bits.
bool IsNumberType(int type);

/// Whether an image's spacing is positive and finite, and its origin finite.
bool CheckPlacement(const double origin[3], const double spacing[3], std::string& why);

/// Whether all of a data set's point arrays are as long as it has points.
bool CheckPointArrays(vtkDataSet* data, std::string& why);

/// Whether an extent is not empty, its indices and lattice coordinates fit int, and its points of
/// so many bytes can be counted.
bool CheckExtent(const int extent[6], int bytesPerPoint, std::string& why);

/// Whether an array of that extent fits the machine's memory. Implies CheckExtent.
bool CheckMemory(const int extent[6], int bytesPerPoint, std::string& why);

} // namespace bravais

#endif
