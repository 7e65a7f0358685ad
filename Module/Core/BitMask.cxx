// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BitMask.h"

#include <algorithm>
#include <bitset>

namespace bravais
{

//------------------------------------------------------------------------------
BitMask::BitMask(std::uint32_t width, std::uint32_t height)
  : Width(width)
  , Height(height)
  , Bytes(GetMaskSize(std::uint64_t{ width } * height))
{
}

//------------------------------------------------------------------------------
std::uint64_t BitMask::Count() const
{
  std::uint64_t count = 0;
  for (const std::uint8_t byte : this->Bytes)
  {
    count += std::bitset<8>(byte).count();
  }
  return count;
}

//------------------------------------------------------------------------------
bool BitMask::Unite(const BitMask& other)
{
  if (other.Width != this->Width || other.Height != this->Height)
  {
    return false;
  }
  std::transform(this->Bytes.begin(), this->Bytes.end(), other.Bytes.begin(), this->Bytes.begin(),
    [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
  return true;
}

//------------------------------------------------------------------------------
bool BitMask::Intersect(const BitMask& other)
{
  if (other.Width != this->Width || other.Height != this->Height)
  {
    return false;
  }
  std::transform(this->Bytes.begin(), this->Bytes.end(), other.Bytes.begin(), this->Bytes.begin(),
    [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a & b); });
  return true;
}

//------------------------------------------------------------------------------
BitMask BitMask::DownSample(int log2Step) const
{
  const std::uint64_t last = (std::uint64_t{ 1 } << log2Step) - 1;
  BitMask coarse(static_cast<std::uint32_t>((this->Width + last) >> log2Step),
    static_cast<std::uint32_t>((this->Height + last) >> log2Step));
  for (std::uint64_t byte = 0; byte < this->Bytes.size(); ++byte)
  {
    for (unsigned int bits = this->Bytes[byte], bit = 0; bits; bits >>= 1, ++bit)
    {
      if (bits & 1)
      {
        const std::uint64_t gixel = 8 * byte + bit;
        coarse.Set(
          (gixel / this->Width >> log2Step) * coarse.Width + (gixel % this->Width >> log2Step));
      }
    }
  }
  return coarse;
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> PackBits(const std::uint8_t* values, std::uint64_t count)
{
  std::vector<std::uint8_t> bits(GetMaskSize(count));
  for (std::uint64_t gixel = 0; gixel < count; ++gixel)
  {
    bits[gixel / 8] =
      static_cast<std::uint8_t>(bits[gixel / 8] | (values[gixel] ? 1U : 0U) << gixel % 8);
  }
  return bits;
}

//------------------------------------------------------------------------------
void UnpackBits(const std::uint8_t* bits, std::uint64_t count, std::uint8_t* values)
{
  for (std::uint64_t gixel = 0; gixel < count; ++gixel)
  {
    values[gixel] = static_cast<std::uint8_t>(bits[gixel / 8] >> gixel % 8 & 1);
  }
}

} // namespace bravais
