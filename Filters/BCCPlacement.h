// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCPlacement_h
#define BCCPlacement_h

/// \file
/// Where in a Cartesian image the points of a BCC volume lie: all that vtkImageToBCCVolume's
/// passes have to agree on.

#include "vtkBravaisABINamespace.h"
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// What the passes need of the input's information.
struct ImageGrid
{
  int Whole[6];
  double Origin[3];
  double Spacing[3];
  double Direction[9];
};

/// False, with a sentence, for less than two points along an axis, or a spacing or origin that
/// cannot be used.
bool ReadGrid(vtkInformation* info, ImageGrid& grid, std::string& why);

/// A lattice whose box is in the image's box. Its point of lattice coordinates (X, Y, Z) is at the
/// image's continuous index Start + Step * (X, Y, Z).
struct BCCPlacement
{
  int Dimensions[3];
  double Spacing[3];
  double Start[3];
  double Step[3];

  /// Whether the lattice is the coarser one: fewer points per volume than the image, or coarser
  /// along an axis.
  bool IsDecimation() const;

  /// World position of the lattice's first point.
  void GetOrigin(const ImageGrid& grid, double origin[3]) const;

  /// Matrix from an output index to the image's index, for the layers of a coset; row major.
  void GetMatrix(int coset, double matrix[16]) const;

  /// The image's indices from the one at or below the first point of an output extent to the one
  /// at or above its last, grown by `margin` and cut to the image's whole extent.
  void GetImageExtent(
    const ImageGrid& grid, const int extent[6], const int margin[3], int imageExtent[6]) const;
};

/// Every second point of each of two cosets.
BCCPlacement PlaceSubset(const ImageGrid& grid);

/// Whether dimensions, or a ratio where they are 0, are good for any image, as far as that can be
/// told without one.
bool CheckIsotropic(const int dimensions[3], double ratio, std::string& why);

/// An isotropic lattice of given dimensions, or, if they are 0, of about `ratio` times the image's
/// points, in the middle of the image. False, with a sentence, if there is none.
bool PlaceIsotropic(const ImageGrid& grid, const int dimensions[3], double ratio,
  BCCPlacement& placement, std::string& why);

} // namespace bravais

#endif
