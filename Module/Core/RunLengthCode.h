// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RunLengthCode_h
#define RunLengthCode_h

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// \file
/// The run-length code of locality masks. A run of two or more equal bytes is the byte twice and
/// how many there are in 16 bits, the lower byte first; a lone byte is itself. Longer runs than
/// 65535 are several. A mask of n gixels is (n + 7) / 8 bytes, see BitMask.

namespace bravais
{

/// Code of any bytes, appended to `code`.
void AppendRunLengthCode(
  const std::uint8_t* bytes, std::uint64_t size, std::vector<std::uint8_t>& code);

/// Code of the mask of an image of so many gixels in which `count` are set, whose places are given
/// in ascending order: O(count), without the mask.
void AppendRunLengthCode(const std::uint32_t* places, std::size_t count, std::uint64_t gixels,
  std::vector<std::uint8_t>& code);

/// How many bytes that code has.
std::uint64_t GetRunLengthSize(
  const std::uint32_t* places, std::size_t count, std::uint64_t gixels);

/// The bytes; none if the code is not one of `size` bytes.
std::optional<std::vector<std::uint8_t>> DecodeRunLength(
  const std::uint8_t* code, std::size_t codeSize, std::uint64_t size);

/// What is done with a mask that AppendRunLengthCode has coded, without making it first. The code
/// is trusted. OrRunLengthCode unites it with a mask's bytes; PaintRunLengthCode writes 1 to one
/// byte a gixel where it has a bit, and nothing elsewhere.
void OrRunLengthCode(const std::uint8_t* code, const std::uint8_t* end, std::uint8_t* mask);
void PaintRunLengthCode(
  const std::uint8_t* code, const std::uint8_t* end, std::uint64_t gixels, std::uint8_t* values);

} // namespace bravais

#endif
