// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCSubset_h
#define BCCSubset_h

#include "vtkBravaisABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Copies all point arrays of `input` at the points of `output`, whose extent is set: the point
/// (i, j, k) from the index (2 i + (k & 1), 2 j + (k & 1), k), counted from `first`. False if
/// aborted.
bool CopySubset(vtkAlgorithm* self, vtkImageData* input, const int first[3], vtkImageData* output);

} // namespace bravais

#endif
