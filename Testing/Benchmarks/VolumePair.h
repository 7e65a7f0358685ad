// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumePair_h
#define VolumePair_h

/// \file
/// Volumes that are drawn beside each other: one function on a BCC lattice and on a Cartesian one
/// of as many samples.

#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace bravais
{

/// One function on both lattices, and how it is looked at.
struct VolumePair
{
  std::string Name;
  vtkSmartPointer<vtkImageData> BCC;
  vtkSmartPointer<vtkImageData> Cartesian;
  double IsoValue = 0.0;
  std::vector<std::pair<double, double>> Opacities; ///< scalars and opacities
  int Width = 512;
  int Height = 512;
};

/// The Marschner-Lobb function on n x n x 2n points, and on as many Cartesian ones.
VolumePair MakeMarschnerLobb(int n, int width, int height);

/// A head of ellipsoids in air: skin, bone, brain; dimensions are those of the BCC volume.
VolumePair MakeHead(const std::string& name, const int dimensions[3], int width, int height);

/// A MetaImage file, resampled to a BCC volume of as many samples; its range maps to a head's.
/// Null pointers if it cannot be read.
VolumePair ReadPair(const std::string& path, double isoValue, int width, int height);

} // namespace bravais

#endif
