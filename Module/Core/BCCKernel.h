// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCKernel_h
#define BCCKernel_h

#include <optional>

namespace bravais
{

/// The reconstruction kernels of the BCC lattice, by their number of directions.
enum class BCCKernel : int
{
  BCC4 = 4,  ///< linear box-spline, the 4 directions of S1
  BCC7 = 7,  ///< quartic box-spline, the 4 directions of S1 and the 3 of S2
  BCC8 = 8,  ///< quintic box-spline, the 4 directions of S1 twice
  BCC12 = 12 ///< tri-cubic B-spline, the 3 directions of S2 four times
};

/// The kernel of that number, if there is one.
std::optional<BCCKernel> ToBCCKernel(int number);

/// "BCC4", "BCC7", "BCC8" or "BCC12".
const char* GetName(BCCKernel kernel);

} // namespace bravais

#endif
