// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Texels_h
#define Rank1Texels_h

#include "Rank1Sampling.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace bravais
{

/// The texels of a rank-1 texture's levels, and look-ups in them.
class Rank1Texels
{
public:
  /// A rank-1 image or blocks of them. Nothing is done for one that was taken last and has not
  /// changed since. False, with a sentence in `why`, where it is no texture.
  bool SetSource(vtkDataObject* texture, std::string& why);

  void Clear();

  int GetNumberOfComponents() const;

  /// Filtered values of points of two coordinates and footprints of four numbers. Any number of
  /// threads may ask at a time.
  void Sample(vtkIdType count, const double* uv, const double* footprints, double* values) const;

  Rank1Sampling Sampling;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; ///< of each level
  vtkDataObject* Source = nullptr;                   // compared only
  vtkMTimeType SourceTime = 0;
};

} // namespace bravais

#endif
