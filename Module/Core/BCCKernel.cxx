// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCKernel.h"

namespace bravais
{

std::optional<BCCKernel> ToBCCKernel(int number)
{
  switch (number)
  {
    case 4:
    case 7:
    case 8:
    case 12:
      return static_cast<BCCKernel>(number);
    default:
      return std::nullopt;
  }
}

const char* GetName(BCCKernel kernel)
{
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return "BCC4";
    case BCCKernel::BCC7:
      return "BCC7";
    case BCCKernel::BCC8:
      return "BCC8";
    case BCCKernel::BCC12:
      break;
  }
  return "BCC12";
}

} // namespace bravais
