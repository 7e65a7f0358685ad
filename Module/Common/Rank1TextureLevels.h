// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1TextureLevels_h
#define Rank1TextureLevels_h

/// \file
/// The levels of a rank-1 texture, as vtkRank1TexturePyramid lays them out and as sampler and
/// mapper read them.
///
/// A texture is a rank-1 image, which is a texture of one level, or a vtkMultiBlockDataSet of them:
/// - Mip levels: block l is level l. All blocks have the same S x T tiles, and block l has n / 4^l
///   texels in each of them, rounded down.
/// - An r-set: block j columns + i is member (i, j). All blocks have the same n texels in each
/// tile,
///   and the same generator. Member (i, j) has max(1, S / 2^i) x max(1, T / 2^j) tiles, rounded
///   down. There are columns = floor(log2 S) + 1 and rows = floor(log2 T) + 1 of them.
///
/// Which kind it is follows from the blocks' dimensions (n, S, T) alone, so a texture that was
/// written to a file and read again is still one. All blocks have the same `Rank1.Domain`, scalar
/// type and number of components.

#include "vtkBravaisABINamespace.h"
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

struct Rank1TextureLevels
{
  std::vector<vtkImageData*> Images; ///< not owned; images[j columns + i]
  int Columns = 0;                   ///< number of mip levels, or of an r-set's halvings of S + 1
  int Rows = 0;                      ///< 1 for mip levels, or of an r-set's halvings of T + 1
  bool IsRSet = false;               ///< several images of the same n
};

/// The levels of a data object. False, with a sentence in `why`, where it is neither a rank-1 image
/// nor laid out as above. Texels' values are not looked at.
bool GetRank1TextureLevels(vtkDataObject* data, Rank1TextureLevels& levels, std::string& why);

} // namespace bravais

#endif
