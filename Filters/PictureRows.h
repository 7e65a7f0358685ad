// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureRows_h
#define PictureRows_h

#include "Rank1Resampler.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Rows of a picture that its source makes a few of at a time, and what is beyond its border.
class PictureRows
{
public:
  /// Rows of the output of a port of an algorithm, whose information is up to date.
  PictureRows(vtkAlgorithm* source, int port, Rank1Boundary boundary);

  int GetWidth() const { return this->Whole[1] - this->Whole[0] + 1; }
  int GetHeight() const { return this->Whole[3] - this->Whole[2] + 1; }
  int GetType() const { return this->Type; }
  int GetNumberOfComponents() const { return this->Components; }

  /// Finds out type and number of components from the first row.
  bool Begin(std::string& why);

  /// Holds the rows first .. last - 1; those below 0 and beyond the last follow from the boundary.
  bool Fetch(int first, int last, std::string& why);

  /// Pixel 0 of a row that is held.
  const char* GetRow(int row) const
  {
    return this->Values.data() + static_cast<std::size_t>(row - this->First) * this->RowBytes;
  }

  /// The column of the picture that is at a column, by the boundary.
  int WrapColumn(int column) const { return this->Wrap(column, this->GetWidth()); }

private:
  int Wrap(int place, int count) const;
  bool FetchPart(int first, int last, std::string& why);

  vtkAlgorithm* Source;
  int Port;
  Rank1Boundary Boundary;
  int Whole[6] = { 0, -1, 0, -1, 0, -1 };
  int Type = 0;
  int Components = 0;
  std::size_t RowBytes = 0;
  int First = 0;
  std::vector<char> Values;
};

} // namespace bravais

#endif
