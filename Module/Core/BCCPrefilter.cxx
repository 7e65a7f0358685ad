// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCPrefilter.h"

namespace bravais
{

std::optional<BCCPrefilter> ToBCCPrefilter(int number)
{
  return number >= 0 && number <= 3 ? std::optional(static_cast<BCCPrefilter>(number))
                                    : std::nullopt;
}

const char* GetName(BCCPrefilter prefilter)
{
  switch (prefilter)
  {
    case BCCPrefilter::None:
      return "None";
    case BCCPrefilter::QuasiInterpolation:
      return "QuasiInterpolation";
    case BCCPrefilter::Interpolation:
      return "Interpolation";
    case BCCPrefilter::Projection:
      break;
  }
  return "Projection";
}

bool IsDefined(BCCKernel kernel, BCCPrefilter prefilter)
{
  return prefilter != BCCPrefilter::Interpolation || kernel == BCCKernel::BCC4 ||
    kernel == BCCKernel::BCC8;
}

} // namespace bravais
