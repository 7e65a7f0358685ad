// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GimFile_h
#define GimFile_h

/// \file
/// .gim files: two 32-bit integers, width and height, and width x height x 3 32-bit floats, xyz,
/// row after row; all little-endian.

#include "GeometryImage.h"

#include <string>

namespace bravais
{

/// Width and height. False, with the reason, if the file cannot be read, or if its header does not
/// go with its size, so that what is said can be relied upon.
bool ReadGimHeader(const std::string& path, int size[2], std::string& why);

/// Rows first .. last, 3 floats a gixel, in a file whose header has been read.
bool ReadGimRows(
  const std::string& path, const int size[2], int first, int last, float* points, std::string& why);

/// Gixels that are not used are written as NaN.
bool WriteGim(const std::string& path, const GixelView& gixels, std::string& why);

} // namespace bravais

#endif
