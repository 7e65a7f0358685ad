// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BitMask_h
#define BitMask_h

#include <cstdint>
#include <vector>

namespace bravais
{

/// Bytes of a mask of so many gixels: row-major bits, least significant first, no row padding.
constexpr std::uint64_t GetMaskSize(std::uint64_t gixels)
{
  return (gixels + 7) / 8;
}

/**
 * A locality mask, uncompressed: a bit a gixel of a width x height image, row-major, the least
 * significant bit of a byte first, rows without padding. Bits beyond the last gixel are 0.
 */
class BitMask
{
public:
  BitMask(std::uint32_t width, std::uint32_t height);

  std::uint32_t GetWidth() const { return this->Width; }
  std::uint32_t GetHeight() const { return this->Height; }
  std::uint64_t GetNumberOfGixels() const { return std::uint64_t{ this->Width } * this->Height; }

  std::vector<std::uint8_t>& GetBytes() { return this->Bytes; }
  const std::vector<std::uint8_t>& GetBytes() const { return this->Bytes; }

  bool Get(std::uint64_t gixel) const { return this->Bytes[gixel / 8] >> gixel % 8 & 1; }
  void Set(std::uint64_t gixel)
  {
    this->Bytes[gixel / 8] = static_cast<std::uint8_t>(this->Bytes[gixel / 8] | 1U << gixel % 8);
  }

  std::uint64_t Count() const;

  /// Union and intersection with a mask of the same width and height; false for another.
  bool Unite(const BitMask& other);
  bool Intersect(const BitMask& other);

  /// The mask of every 2^log2Step-th gixel of every 2^log2Step-th row, one set where any is of
  /// the region of 2^log2Step x 2^log2Step gixels that starts at it. log2Step from 0 to 31.
  BitMask DownSample(int log2Step) const;

private:
  std::uint32_t Width;
  std::uint32_t Height;
  std::vector<std::uint8_t> Bytes;
};

/// A bit for each byte, set where it is not 0, and back to 0 and 1.
std::vector<std::uint8_t> PackBits(const std::uint8_t* values, std::uint64_t count);
void UnpackBits(const std::uint8_t* bits, std::uint64_t count, std::uint8_t* values);

} // namespace bravais

#endif
