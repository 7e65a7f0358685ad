// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WholeJPEG.h"

#include "vtksys/FStream.hxx"

namespace bravais
{

namespace
{

constexpr int Marker = 0xff; ///< the byte before a marker's number
constexpr int EndOfImage = 0xd9;

/// Markers that no length follows: restarts, starts and ends, and the byte 0xff of the data.
bool IsAlone(int number)
{
  return number <= 0x01 || (number >= 0xd0 && number <= EndOfImage);
}

} // namespace

//------------------------------------------------------------------------------
bool IsWholeJPEG(const std::string& name)
{
  vtksys::ifstream file(name.c_str(), std::ios::in | std::ios::binary);
  while (file)
  {
    // To the next marker: nothing lies between segments, and the data of a scan after its header.
    while (file && file.get() != Marker)
    {
    }
    int number = file.get();
    while (number == Marker)
    {
      number = file.get();
    }
    if (number == EndOfImage)
    {
      return true;
    }
    if (file && !IsAlone(number))
    {
      const int high = file.get();
      const int low = file.get();
      file.seekg(256 * high + low - 2, std::ios::cur);
    }
  }
  return false;
}

} // namespace bravais
