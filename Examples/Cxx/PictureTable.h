// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureTable_h
#define PictureTable_h

/// \file
/// A table of pictures and what they took.

#include "vtkType.h"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

struct PictureRow
{
  std::string Picture;
  std::string Kernel;
  std::string Prefilter;
  vtkIdType Samples = 0;
  double Seconds = 0.0;
  std::optional<double> Error; ///< root mean square, where the truth is known
};

class PictureTable
{
public:
  void Add(const PictureRow& row) { this->Rows.push_back(row); }
  void Print(std::ostream& stream) const;

private:
  std::vector<PictureRow> Rows;
};

#endif
