// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OIIOImageFiller_h
#define OIIOImageFiller_h

#include "OIIOImageFile.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Puts what is read of files into the arrays of an image.
class OIIOImageFiller
{
public:
  /// Reads that extent; row 0 is the file's last where `flip` is true.
  OIIOImageFiller(OIIOImageFile& file, vtkImageData* output, const int extent[6], bool flip);

  /// The file of the next slice, like the first one.
  void SetFile(OIIOImageFile& file);

  /// The file's rows that hold the extent: first, last + 1.
  void GetRows(int rows[2]) const;

  bool ReadBlock(const int rows[2], int layer, std::string& why);

  /// Makes the image's arrays.
  void Allocate();

  /// Copies those rows of a block that the extent has to slice k.
  void StoreBlock(const int rows[2], int k);

private:
  /// Neighbouring channels of one type, which are read together.
  struct Run
  {
    int Channels[2]; ///< first, last + 1
    OIIO::TypeDesc Type;
    std::vector<char> Values; ///< of a block
  };

  static std::vector<Run> MakeRuns(const OIIO::ImageSpec& spec);
  void StoreRow(std::size_t index, std::size_t row, vtkIdType j, vtkIdType k);

  OIIOImageFile* File = nullptr;
  vtkImageData* Output;
  int Extent[6];
  int Columns[2] = { 0, 0 }; ///< of the file that are read
  bool Flip;
  std::vector<Run> Runs;
  std::vector<vtkDataArray*> Arrays;
};

} // namespace bravais

#endif
