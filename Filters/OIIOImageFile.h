// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OIIOImageFile_h
#define OIIOImageFile_h

#include "OIIOChannels.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

namespace bravais
{

/// An image of a file: its header, checked, and parts of its pixels.
class OIIOImageFile
{
public:
  /// What is wrong with a file, for the caller's error code.
  enum class Trouble
  {
    None,
    NotFound,
    Unrecognized,
    Format
  };

  /// Opens an image and checks its header. False, with a sentence in `why`, where that fails.
  bool Open(const std::string& name, int subImage, int mipLevel, std::string& why);

  const std::string& GetName() const { return this->Name; }
  const OIIO::ImageSpec& GetSpec() const { return this->Spec; }
  const std::vector<OIIOChannelArray>& GetArrays() const { return this->Arrays; }
  std::string GetFormat() const { return this->Input->format_name(); }
  Trouble GetTrouble() const { return this->Failure; }

  /// Whether another image has the same size and arrays.
  bool IsLike(const OIIOImageFile& other) const;

  /// Whether the header says that the file's rows go up.
  bool HasLowerRowsFirst() const;

  int CountSubImages();
  int CountMipLevels();

  /// Rows of the file that are best read together, and the first row of the block of a row.
  int GetRowsPerBlock() const;

  /// Columns that have to be read for columns first..last: whole rows, or whole tiles.
  void GetReadColumns(int first, int last, int& begin, int& end) const;

  /// Channels begin .. end - 1 of one type, of columns and rows begin .. end - 1 counted from the
  /// file's first pixel, densely packed. The columns are those of GetReadColumns, the rows a block.
  bool ReadBlock(const int columns[2], const int rows[2], int layer, const int channels[2],
    OIIO::TypeDesc type, void* values, std::string& why);

private:
  bool Fail(Trouble trouble, const std::string& text, std::string& why);
  bool CheckHeader(std::string& why);

  /// Whether it is a TIFF file of numbers of 64 bits.
  bool IsWideTIFF() const;

  std::string Name;
  int SubImage = 0;
  int MipLevel = 0;
  Trouble Failure = Trouble::None;
  OIIO::ImageInput::unique_ptr Input;
  OIIO::ImageSpec Spec;
  std::vector<OIIOChannelArray> Arrays;
};

} // namespace bravais

#endif
