// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SliceLoop_h
#define SliceLoop_h

#include "vtkBravaisABINamespace.h"
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Calls work(k) for k = first..last, in parallel by vtkSMPTools and in any order, so that work
/// must write nothing that another layer reads or writes. Progress runs from `begin` to `end`, and
/// is reported by the calling thread alone, so that observers need no locks. AbortExecute is asked
/// before every layer: the loop then stops early and returns false, and the caller empties its
/// output.
bool ForEachSlice(vtkAlgorithm* self, int first, int last, const std::function<void(int)>& work,
  double begin = 0.0, double end = 1.0);

/// The same in ascending order and in the calling thread, for work that threads may not share.
bool ForEachSliceInOrder(vtkAlgorithm* self, int first, int last,
  const std::function<void(int)>& work, double begin = 0.0, double end = 1.0);

} // namespace bravais

#endif
