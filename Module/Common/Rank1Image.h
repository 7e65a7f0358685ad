// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Image_h
#define Rank1Image_h

/// \file
/// How a rank-1 picture travels: a vtkImageData of dimensions (n, S, T), one row of n texels for
/// each of S x T tiles, tagged Rank1, whose field data hold `Rank1.Generator` (n, g1, g2) and
/// `Rank1.Domain` (xmin, xmax, ymin, ymax of the whole picture).

#include "Rank1Lattice.h"
#include "vtkBravaisABINamespace.h"

#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// What a rank-1 image says of itself.
struct Rank1Image
{
  Rank1Lattice Lattice; ///< of one tile; its size is a tile's width and height
  int Tiles[2];         ///< S, T
  double Domain[4];     ///< xmin, xmax, ymin, ymax
  vtkDataArray* Texels; ///< the point scalars: texel i of tile (x, y) is tuple i + n (x + S y)
};

/// Marks an image whose dimensions are (n, S, T).
void TagRank1Image(vtkImageData* image, const Rank1Lattice& lattice, const double domain[4]);

/// Reads the marks and checks them against the dimensions and the scalars, which have to be
/// numbers, all of them there. None, and `why` a sentence ready for vtkErrorMacro, where something
/// is wrong.
std::optional<Rank1Image> ReadRank1Image(vtkImageData* image, std::string& why);

/// Why there is no lattice of so many points and that generator on an area of that size, or nothing
/// where there is one.
std::string ExplainRank1Lattice(
  long long n, long long g1, long long g2, double width, double height);

} // namespace bravais

#endif
