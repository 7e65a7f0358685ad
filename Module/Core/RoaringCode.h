// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RoaringCode_h
#define RoaringCode_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// \file
/// Locality masks as Roaring bitmaps: S. Chambi, D. Lemire, O. Kaser, R. Godin, "Better bitmap
/// performance with Roaring bitmaps", Software: Practice and Experience 46 (2016), and D. Lemire,
/// G. Ssi-Yan-Kai, O. Kaser, "Consistently faster and smaller compressed bitmaps with Roaring", the
/// same. Each block of 2^16 gixels with any set is the smallest of three containers, as theirs are:
/// the sorted places (2 bytes each), runs of them (first and length - 1, 4 bytes), or 8192 bytes of
/// bits.
///
/// Their portable format has 9 to 16 bytes before the first container, more than a leaf's places
/// often take. Here a container is preceded by two numbers of 7 bits a byte, the lower first and
/// the eighth bit set where another follows: 4 times the empty blocks skipped before it, plus its
/// kind; and its places or runs less 1 (bits have none). All numbers are little-endian.

struct roaring_bitmap_s;

namespace bravais
{

/// Code of the mask of `count` gixels that are set, whose places are given in ascending order.
void AppendRoaringCode(
  const std::uint32_t* places, std::size_t count, std::vector<std::uint8_t>& code);

/// Writes 1 to one byte a gixel where a mask that AppendRoaringCode has coded has a bit, and
/// nothing elsewhere. The code is trusted.
void PaintRoaringCode(const std::uint8_t* code, const std::uint8_t* end, std::uint8_t* values);

/**
 * Union of coded masks by CRoaring, container by container: none of them is decompressed. A code's
 * containers are shown to CRoaring where they are, but for a copy that aligns them.
 */
class RoaringUnion
{
public:
  RoaringUnion();
  ~RoaringUnion();
  RoaringUnion(const RoaringUnion&) = delete;
  void operator=(const RoaringUnion&) = delete;

  /// Unites with a mask that AppendRoaringCode has coded.
  void Add(const std::uint8_t* code, const std::uint8_t* end);

  /// To be called after the last Add and before what follows.
  void Finish();

  std::uint64_t Count() const;
  std::vector<std::uint32_t> GetPlaces() const;
  std::size_t GetPortableSize() const; // bytes in CRoaring's own format

  /// Writes 1 where the union has a bit, as PaintRoaringCode does.
  void Paint(std::uint8_t* values) const;

  /// The union's code.
  std::vector<std::uint8_t> Encode() const;

private:
  struct Scratch;
  roaring_bitmap_s* Bitmap;
  std::unique_ptr<Scratch> Work;
};

} // namespace bravais

#endif
