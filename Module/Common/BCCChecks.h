// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCChecks_h
#define BCCChecks_h

/// \file
/// What every filter of BCC volumes asks before it starts; ImageChecks.h has what is not theirs
/// alone. A check that fails returns false and sets `why`, ready for vtkErrorMacro.

#include "ImageChecks.h"
#include "vtkBravaisABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Whether an image can be read as a BCC volume: tagged, at least one point along x and y and two
/// layers, a positive and finite spacing, a finite origin, and point scalars that are numbers. The
/// extent that is judged is `whole`, or the image's own where that is nullptr.
bool CheckBCCImage(vtkImageData* image, const int whole[6], std::string& why);
bool CheckBCCImage(vtkImageData* image, std::string& why);

} // namespace bravais

#endif
