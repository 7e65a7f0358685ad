// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCPaddedLayer_h
#define BCCPaddedLayer_h

#include "BCCBlock.h"
#include "BCCKernel.h"

#include <vector>

namespace bravais
{

/// Fills one layer of coefficients, continued by the mirrors beyond the box of the volume, so that
/// a spline near the box's faces can be evaluated without a test.
///
/// `planes` has one block for each component of `samples`, all of one extent, which contains
/// layer k and may reach beyond `whole` on every side; layer k itself may lie beyond it. The
/// coefficients are the samples, or their quasi-interpolation for `kernel`. `samples` covers,
/// within `whole`, the planes' indices and one more on each side, and the layers next to k's image.
/// R is BCCCoefficient<T>, or T and R are both float or both double.
template <class T, class R>
void FillPaddedLayer(BCCKernel kernel, bool quasiInterpolate, const BCCExtent& whole,
  const BCCBlock<const T>& samples, int k, const std::vector<BCCBlock<R>>& planes);

} // namespace bravais

#endif
