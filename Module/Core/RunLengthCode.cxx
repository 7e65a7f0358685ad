// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunLengthCode.h"

#include "BitMask.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace bravais
{

namespace
{

constexpr std::uint64_t LongestRun = 0xffff;

/// Collects equal bytes and writes them as runs, or only counts what it would write.
class RunWriter
{
public:
  explicit RunWriter(std::vector<std::uint8_t>* code)
    : Code(code)
  {
  }
  RunWriter(const RunWriter&) = delete;
  void operator=(const RunWriter&) = delete;

  void Add(std::uint8_t byte, std::uint64_t count)
  {
    if (byte != this->Byte)
    {
      this->EndRun();
      this->Byte = byte;
    }
    this->Count += count;
  }

  /// To be called at the end; how many bytes the code has.
  std::uint64_t Finish()
  {
    this->EndRun();
    this->Flush();
    return this->Written;
  }

private:
  void EndRun()
  {
    for (; this->Count > 1; this->Count -= std::min(this->Count, LongestRun))
    {
      const std::uint64_t run = std::min(this->Count, LongestRun);
      this->Write(this->Byte);
      this->Write(this->Byte);
      this->Write(static_cast<std::uint8_t>(run & 0xff));
      this->Write(static_cast<std::uint8_t>(run >> 8));
    }
    if (this->Count)
    {
      this->Write(this->Byte);
    }
    this->Count = 0;
  }

  void Write(std::uint8_t byte)
  {
    if (this->Held == this->Buffer.size())
    {
      this->Flush();
    }
    this->Buffer[this->Held++] = byte;
  }

  void Flush()
  {
    if (this->Code)
    {
      this->Code->insert(
        this->Code->end(), this->Buffer.begin(), this->Buffer.begin() + this->Held);
    }
    this->Written += this->Held;
    this->Held = 0;
  }

  std::vector<std::uint8_t>* Code;
  std::array<std::uint8_t, 512> Buffer;
  std::uint32_t Held = 0;
  std::uint64_t Written = 0;
  std::uint8_t Byte = 0;
  std::uint64_t Count = 0;
};

/// The mask of gixels whose places are given in ascending order.
void AddPlaces(
  const std::uint32_t* places, std::size_t count, std::uint64_t gixels, RunWriter& writer)
{
  std::uint64_t next = 0; // the byte that is to be written next
  for (std::size_t n = 0; n < count;)
  {
    const std::uint64_t at = places[n] / 8;
    unsigned int byte = 0;
    for (; n < count && places[n] / 8 == at; ++n)
    {
      byte |= 1U << places[n] % 8;
    }
    if (at > next)
    {
      writer.Add(0, at - next);
    }
    writer.Add(static_cast<std::uint8_t>(byte), 1);
    next = at + 1;
  }
  if (GetMaskSize(gixels) > next)
  {
    writer.Add(0, GetMaskSize(gixels) - next);
  }
}

/// The next run of a code, and where the one after it begins.
struct Run
{
  std::uint8_t Byte;
  std::uint64_t Count;
};

Run ReadRun(const std::uint8_t*& code, const std::uint8_t* end)
{
  const std::uint8_t byte = *code;
  if (end - code >= 4 && code[1] == byte)
  {
    const std::uint64_t count = code[2] | std::uint64_t{ code[3] } << 8;
    code += 4;
    return { byte, count };
  }
  ++code;
  return { byte, 1 };
}

/// Eight bytes of 0 and 1 for each byte of a mask.
std::array<std::array<std::uint8_t, 8>, 256> MakeSpread()
{
  std::array<std::array<std::uint8_t, 8>, 256> spread;
  for (unsigned int byte = 0; byte < 256; ++byte)
  {
    for (unsigned int bit = 0; bit < 8; ++bit)
    {
      spread[byte][bit] = static_cast<std::uint8_t>(byte >> bit & 1);
    }
  }
  return spread;
}

/// Unites eight values with a byte of a mask.
void PaintByte(std::uint8_t byte, std::uint8_t* values)
{
  static const auto spread = MakeSpread();
  std::uint64_t old;
  std::uint64_t bits;
  std::memcpy(&old, values, 8);
  std::memcpy(&bits, spread[byte].data(), 8);
  old |= bits;
  std::memcpy(values, &old, 8);
}

/// A run at the place of its first bit.
void PaintRun(const Run& run, std::uint64_t place, std::uint64_t gixels, std::uint8_t* values)
{
  if (run.Byte == 0xff)
  {
    std::memset(values + place, 1, std::min(8 * run.Count, gixels - place));
    return;
  }
  const std::uint64_t end = place + 8 * run.Count;
  for (; place < end && place + 8 <= gixels; place += 8)
  {
    PaintByte(run.Byte, values + place);
  }
  for (; place < std::min(end, gixels); ++place)
  {
    values[place] = static_cast<std::uint8_t>(values[place] | (run.Byte >> place % 8 & 1));
  }
}

} // namespace

//------------------------------------------------------------------------------
void AppendRunLengthCode(
  const std::uint8_t* bytes, std::uint64_t size, std::vector<std::uint8_t>& code)
{
  RunWriter writer(&code);
  for (std::uint64_t place = 0; place < size; ++place)
  {
    writer.Add(bytes[place], 1);
  }
  writer.Finish();
}

//------------------------------------------------------------------------------
void AppendRunLengthCode(const std::uint32_t* places, std::size_t count, std::uint64_t gixels,
  std::vector<std::uint8_t>& code)
{
  RunWriter writer(&code);
  AddPlaces(places, count, gixels, writer);
  writer.Finish();
}

//------------------------------------------------------------------------------
std::uint64_t GetRunLengthSize(const std::uint32_t* places, std::size_t count, std::uint64_t gixels)
{
  RunWriter writer(nullptr);
  AddPlaces(places, count, gixels, writer);
  return writer.Finish();
}

//------------------------------------------------------------------------------
std::optional<std::vector<std::uint8_t>> DecodeRunLength(
  const std::uint8_t* code, std::size_t codeSize, std::uint64_t size)
{
  std::vector<std::uint8_t> bytes;
  const std::uint8_t* const end = code + codeSize;
  while (code != end)
  {
    if (end - code > 1 && code[1] == code[0] && end - code < 4)
    {
      return std::nullopt; // a run without its length
    }
    const Run run = ReadRun(code, end);
    if (run.Count < 1 || run.Count > size - bytes.size())
    {
      return std::nullopt;
    }
    bytes.insert(bytes.end(), static_cast<std::size_t>(run.Count), run.Byte);
  }
  return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

//------------------------------------------------------------------------------
void OrRunLengthCode(const std::uint8_t* code, const std::uint8_t* end, std::uint8_t* mask)
{
  while (code != end)
  {
    const Run run = ReadRun(code, end);
    if (run.Byte)
    {
      for (std::uint64_t byte = 0; byte < run.Count; ++byte)
      {
        mask[byte] = static_cast<std::uint8_t>(mask[byte] | run.Byte);
      }
    }
    mask += run.Count;
  }
}

//------------------------------------------------------------------------------
void PaintRunLengthCode(
  const std::uint8_t* code, const std::uint8_t* end, std::uint64_t gixels, std::uint8_t* values)
{
  std::uint64_t place = 0;
  while (code != end)
  {
    const Run run = ReadRun(code, end);
    if (run.Byte)
    {
      PaintRun(run, place, gixels, values);
    }
    place += 8 * run.Count;
  }
}

} // namespace bravais
