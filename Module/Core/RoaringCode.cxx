// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RoaringCode.h"

#include "BitMask.h"

#include <roaring/containers/containers.h>
#include <roaring/roaring.h>

#include <algorithm>
#include <bitset>
#include <cstring>
#include <new>

namespace bravais
{

namespace
{

enum Kind : std::uint32_t
{
  Places,
  Runs,
  Bits
};

constexpr std::size_t BitsSize = 8192;
constexpr std::uint32_t BlockMask = 0xffff;

void AppendNumber(std::uint32_t number, std::vector<std::uint8_t>& code)
{
  for (; number > 0x7f; number >>= 7)
  {
    code.push_back(static_cast<std::uint8_t>(number | 0x80));
  }
  code.push_back(static_cast<std::uint8_t>(number));
}

std::uint32_t ReadNumber(const std::uint8_t*& code)
{
  std::uint32_t number = 0;
  for (int shift = 0;; shift += 7)
  {
    const std::uint32_t byte = *code++;
    number |= (byte & 0x7f) << shift;
    if (byte < 0x80)
    {
      return number;
    }
  }
}

/// Writes 16 bits and steps on.
void WriteShort(std::uint32_t number, std::uint8_t*& out)
{
  *out++ = static_cast<std::uint8_t>(number & 0xff);
  *out++ = static_cast<std::uint8_t>(number >> 8 & 0xff);
}

/// Room for so many bytes more, all 0.
std::uint8_t* Extend(std::vector<std::uint8_t>& code, std::size_t bytes)
{
  code.resize(code.size() + bytes);
  return code.data() + code.size() - bytes;
}

std::uint16_t ReadShort(const std::uint8_t* code)
{
  return static_cast<std::uint16_t>(code[0] | code[1] << 8);
}

/// A container as it lies in the code.
struct Container
{
  std::uint32_t Block;
  Kind Type;
  std::uint32_t Size; // places or runs
  const std::uint8_t* Data;
};

Container ReadContainer(const std::uint8_t*& code, std::uint32_t block)
{
  const std::uint32_t head = ReadNumber(code);
  Container container{ block + (head >> 2), static_cast<Kind>(head & 3), 0, nullptr };
  container.Size = container.Type == Bits ? 0 : ReadNumber(code) + 1;
  container.Data = code;
  code += container.Type == Bits ? BitsSize : (container.Type == Runs ? 4 : 2) * container.Size;
  return container;
}

/// The container of places that are all in one block, which so many empty ones precede.
void AppendContainer(const std::uint32_t* places, std::size_t count, std::uint32_t skipped,
  std::vector<std::uint8_t>& code)
{
  std::uint32_t runs = 1;
  for (std::size_t n = 1; n < count; ++n)
  {
    runs += places[n] != places[n - 1] + 1;
  }
  const std::size_t smallest = std::min({ 4 * std::size_t{ runs }, 2 * count, BitsSize });
  if (smallest == 4 * std::size_t{ runs })
  {
    AppendNumber(skipped << 2 | Runs, code);
    AppendNumber(runs - 1, code);
    std::uint8_t* out = Extend(code, smallest);
    for (std::size_t first = 0, n = 1; n <= count; ++n)
    {
      if (n == count || places[n] != places[n - 1] + 1)
      {
        WriteShort(places[first], out);
        WriteShort(static_cast<std::uint32_t>(n - 1 - first), out);
        first = n;
      }
    }
  }
  else if (smallest == 2 * count)
  {
    AppendNumber(skipped << 2 | Places, code);
    AppendNumber(static_cast<std::uint32_t>(count) - 1, code);
    std::uint8_t* out = Extend(code, smallest);
    for (std::size_t n = 0; n < count; ++n)
    {
      WriteShort(places[n], out);
    }
  }
  else
  {
    AppendNumber(skipped << 2 | Bits, code);
    std::uint8_t* out = Extend(code, BitsSize);
    for (std::size_t n = 0; n < count; ++n)
    {
      std::uint8_t& byte = out[(places[n] & BlockMask) / 8];
      byte = static_cast<std::uint8_t>(byte | 1U << places[n] % 8);
    }
  }
}

void PaintBits(const std::uint8_t* bits, std::uint8_t* values)
{
  for (std::size_t place = 0; place < 8 * BitsSize; ++place)
  {
    if (bits[place / 8] >> place % 8 & 1)
    {
      values[place] = 1;
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void AppendRoaringCode(
  const std::uint32_t* places, std::size_t count, std::vector<std::uint8_t>& code)
{
  std::uint32_t next = 0; // the block that is to be written next
  for (std::size_t first = 0; first < count;)
  {
    const std::uint32_t block = places[first] >> 16;
    std::size_t last = first + 1;
    while (last < count && places[last] >> 16 == block)
    {
      ++last;
    }
    AppendContainer(places + first, last - first, block - next, code);
    next = block + 1;
    first = last;
  }
}

//------------------------------------------------------------------------------
void PaintRoaringCode(const std::uint8_t* code, const std::uint8_t* end, std::uint8_t* values)
{
  for (std::uint32_t block = 0; code != end; ++block)
  {
    const Container container = ReadContainer(code, block);
    block = container.Block;
    std::uint8_t* out = values + (std::size_t{ block } << 16);
    if (container.Type == Bits)
    {
      PaintBits(container.Data, out);
    }
    else if (container.Type == Runs)
    {
      for (std::uint32_t n = 0; n < container.Size; ++n)
      {
        const std::uint8_t* run = container.Data + 4 * n;
        std::memset(out + ReadShort(run), 1, std::size_t{ ReadShort(run + 2) } + 1);
      }
    }
    else
    {
      for (std::uint32_t n = 0; n < container.Size; ++n)
      {
        out[ReadShort(container.Data + 2 * n)] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
/// What CRoaring is shown of one container.
struct RoaringUnion::Scratch
{
  std::vector<std::uint16_t> Numbers = std::vector<std::uint16_t>(BlockMask + 1);
  alignas(32) std::uint64_t Words[BitsSize / 8];
};

//------------------------------------------------------------------------------
RoaringUnion::RoaringUnion()
  : Bitmap(roaring_bitmap_create())
  , Work(std::make_unique<Scratch>())
{
  if (!this->Bitmap)
  {
    throw std::bad_alloc();
  }
}

//------------------------------------------------------------------------------
RoaringUnion::~RoaringUnion()
{
  roaring_bitmap_free(this->Bitmap);
}

//------------------------------------------------------------------------------
void RoaringUnion::Add(const std::uint8_t* code, const std::uint8_t* end)
{
  std::uint16_t* numbers = this->Work->Numbers.data();
  for (std::uint32_t block = 0; code != end; ++block)
  {
    const Container container = ReadContainer(code, block);
    block = container.Block;
    const auto size = static_cast<std::int32_t>(container.Size);
    array_container_t places{ size, size, numbers };
    run_container_t runs{ size, size, reinterpret_cast<rle16_t*>(numbers) };
    bitset_container_t bits{ 0, this->Work->Words };
    void* data = &places;
    std::uint8_t type = ARRAY_CONTAINER_TYPE_CODE;
    if (container.Type == Bits)
    {
      std::memcpy(this->Work->Words, container.Data, BitsSize);
      for (const std::uint64_t word : this->Work->Words)
      {
        bits.cardinality += static_cast<std::int32_t>(std::bitset<64>(word).count());
      }
      data = &bits;
      type = BITSET_CONTAINER_TYPE_CODE;
    }
    else
    {
      const std::uint32_t shorts = (container.Type == Runs ? 2 : 1) * container.Size;
      for (std::uint32_t n = 0; n < shorts; ++n)
      {
        numbers[n] = ReadShort(container.Data + 2 * n);
      }
      if (container.Type == Runs)
      {
        data = &runs;
        type = RUN_CONTAINER_TYPE_CODE;
      }
    }
    auto key = static_cast<std::uint16_t>(block);
    const roaring_bitmap_t view{ { 1, 1, &data, &key, &type, ROARING_FLAG_FROZEN } };
    roaring_bitmap_lazy_or_inplace(this->Bitmap, &view, true);
  }
}

//------------------------------------------------------------------------------
void RoaringUnion::Finish()
{
  roaring_bitmap_repair_after_lazy(this->Bitmap);
  roaring_bitmap_run_optimize(this->Bitmap);
}

//------------------------------------------------------------------------------
std::uint64_t RoaringUnion::Count() const
{
  return roaring_bitmap_get_cardinality(this->Bitmap);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> RoaringUnion::GetPlaces() const
{
  std::vector<std::uint32_t> places(static_cast<std::size_t>(this->Count()));
  roaring_bitmap_to_uint32_array(this->Bitmap, places.data());
  return places;
}

//------------------------------------------------------------------------------
std::size_t RoaringUnion::GetPortableSize() const
{
  return roaring_bitmap_portable_size_in_bytes(this->Bitmap);
}

//------------------------------------------------------------------------------
void RoaringUnion::Paint(std::uint8_t* values) const
{
  for (const std::uint32_t place : this->GetPlaces())
  {
    values[place] = 1;
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> RoaringUnion::Encode() const
{
  const std::vector<std::uint32_t> places = this->GetPlaces();
  std::vector<std::uint8_t> code;
  AppendRoaringCode(places.data(), places.size(), code);
  return code;
}

} // namespace bravais
