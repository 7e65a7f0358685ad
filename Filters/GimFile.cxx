// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GimFile.h"

#include "vtkByteSwap.h"

#include "vtksys/FStream.hxx"

#include <cstdint>
#include <limits>
#include <vector>

namespace bravais
{

namespace
{

constexpr std::int64_t HeaderSize = 8;
constexpr std::int64_t GixelSize = 12;

} // namespace

//------------------------------------------------------------------------------
bool ReadGimHeader(const std::string& path, int size[2], std::string& why)
{
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  if (!file)
  {
    why = "The file " + path + " cannot be opened.";
    return false;
  }
  file.seekg(0, std::ios::end);
  const auto bytes = static_cast<std::int64_t>(file.tellg());
  file.seekg(0);
  std::int32_t header[2];
  if (bytes < HeaderSize || !file.read(reinterpret_cast<char*>(header), HeaderSize))
  {
    why = "The file " + path + " has " + std::to_string(bytes) +
      " bytes; a .gim file begins with 8 that tell its width and height.";
    return false;
  }
  vtkByteSwap::Swap4LERange(header, 2);
  const std::string told = "The file " + path + " tells of " + std::to_string(header[0]) + " x " +
    std::to_string(header[1]) + " gixels";
  if (header[0] < 1 || header[1] < 1)
  {
    why = told + "; at least 1 x 1 were expected.";
    return false;
  }
  // No overflow: the product of 31 bits each is compared with a quotient.
  const std::int64_t gixels = std::int64_t{ header[0] } * header[1];
  const std::int64_t held = (bytes - HeaderSize) / GixelSize;
  if (gixels != held || bytes != HeaderSize + GixelSize * held)
  {
    why = told + " and has " + std::to_string(bytes) + " bytes; " +
      (gixels > held ? "it is truncated, or no .gim file" : "it is longer than that") +
      ": 8 and 12 a gixel were expected.";
    return false;
  }
  size[0] = header[0];
  size[1] = header[1];
  return true;
}

//------------------------------------------------------------------------------
bool ReadGimRows(
  const std::string& path, const int size[2], int first, int last, float* points, std::string& why)
{
  const std::int64_t values = 3 * std::int64_t{ size[0] };
  const std::int64_t rows = std::int64_t{ last } - first + 1;
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  file.seekg(HeaderSize + 4 * values * first);
  if (!file.read(reinterpret_cast<char*>(points), 4 * values * rows))
  {
    why = "The file " + path + " ends before row " + std::to_string(last) + " does.";
    return false;
  }
  vtkByteSwap::Swap4LERange(points, static_cast<std::size_t>(values * rows));
  return true;
}

//------------------------------------------------------------------------------
bool WriteGim(const std::string& path, const GixelView& gixels, std::string& why)
{
  vtksys::ofstream file(path.c_str(), std::ios::binary);
  std::int32_t header[2] = { static_cast<std::int32_t>(gixels.GetWidth()),
    static_cast<std::int32_t>(gixels.GetHeight()) };
  vtkByteSwap::Swap4LERange(header, 2);
  file.write(reinterpret_cast<const char*>(header), HeaderSize);
  std::vector<float> row(static_cast<std::size_t>(3 * gixels.GetWidth()));
  for (vtkIdType j = 0; j < gixels.GetHeight() && file; ++j)
  {
    GetRow(gixels, j, row.data());
    vtkByteSwap::Swap4LERange(row.data(), row.size());
    file.write(
      reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(4 * row.size()));
  }
  file.close();
  if (!file)
  {
    why = "The file " + path + " cannot be written.";
  }
  return static_cast<bool>(file);
}

} // namespace bravais
