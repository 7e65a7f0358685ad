// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Texels_h
#define Rank1Texels_h

#include "Rank1Sampling.h"
#include "vtkBravaisABINamespace.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <ctime>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace bravais
{

class Rank1TileFile;

/// The texels of a rank-1 texture's levels, and look-ups in them.
class Rank1Texels
{
public:
  Rank1Texels();
  ~Rank1Texels();
  Rank1Texels(const Rank1Texels&) = delete;
  void operator=(const Rank1Texels&) = delete;

  /// A rank-1 image or blocks of them. Nothing is done for one that was taken last and has not
  /// changed since. False, with a sentence in `why`, where it is no texture.
  bool SetSource(vtkDataObject* texture, std::string& why);

  /// A file of tiles, of which the cache keeps so many megabytes. Nothing is done for one that was
  /// taken last and was not written since.
  bool SetFile(const std::string& name, int megabytes, std::string& why);

  /// The file, or nullptr.
  Rank1TileFile* GetFile() const { return this->File.get(); }

  void Clear();

  int GetNumberOfComponents() const;

  /// Filtered values of points of two coordinates and footprints of four numbers. Any number of
  /// threads may ask at a time.
  /// A file's texels that cannot be read make NaN.
  void Sample(vtkIdType count, const double* uv, const double* footprints, double* values) const;

  Rank1Sampling Sampling;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; ///< of each level
  std::unique_ptr<Rank1TileFile> File;               ///< in their place
  std::string FileName;
  std::time_t FileTime = 0;
  int Megabytes = 0;
  vtkDataObject* Source = nullptr; // compared only
  vtkMTimeType SourceTime = 0;
};

} // namespace bravais

#endif
