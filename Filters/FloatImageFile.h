// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FloatImageFile_h
#define FloatImageFile_h

/// \file
/// Geometry images as pictures of floats, by OpenImageIO: channels 0 to 2 are x, y and z, and row 0
/// is the picture's lowest, as VTK has it.

#include "GeometryImage.h"

#include <memory>
#include <string>

namespace bravais
{

/// A picture that is open for reading.
class FloatImageFile
{
public:
  FloatImageFile();
  ~FloatImageFile();

  /// False, with the reason, if it cannot be read as xyz.
  bool Open(const std::string& path, std::string& why);
  const int* GetSize() const { return this->Size; }
  bool IsDouble() const { return this->Double; }

  /// Rows first .. last, 3 numbers a gixel, floats or doubles as the file has it.
  bool ReadRows(int first, int last, void* points, std::string& why);

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
  std::string Path;
  int Size[2] = { 0, 0 };
  bool Double = false;
};

/// Gixels that are not used are written as NaN. False if the format, by the path's ending, does not
/// keep floats as they are.
bool WriteFloatImage(const std::string& path, const GixelView& gixels, std::string& why);

} // namespace bravais

#endif
