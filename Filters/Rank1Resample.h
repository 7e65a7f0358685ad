// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Resample_h
#define Rank1Resample_h

/// \file
/// From a Cartesian picture to a rank-1 image: what vtkRank1ImageResample and the levels of a
/// pyramid have in common. A check that fails sets `why`, ready for vtkErrorMacro.

#include "Rank1Resampler.h"
#include "Rank1Search.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Which picture: its pixels, and where they are. Lengths are along the picture's own axes.
struct Rank1Picture
{
  int Pixels[2];
  double Domain[4]; ///< xmin, xmax, ymin, ymax, from edge to edge
  double Z;         ///< of the picture's plane

  /// Of an image's whole extent. One layer of pixels is expected, in x and y.
  static std::optional<Rank1Picture> Create(const int extent[6], const double origin[3],
    const double spacing[3], const double direction[9], std::string& why);
};

/// What is wanted of it. Zeros stand for what follows from the picture.
struct Rank1ResampleParameters
{
  vtkIdType NumberOfPoints = 0; ///< of a tile; 0: as many texels as pixels
  int Tiles[2] = { 1, 1 };
  vtkIdType Generator[2] = { 0, 0 }; ///< 0, 0: the largest minimum distance
  Rank1Layout Layout = Rank1Layout::Korobov;
  std::optional<Rank1Filter> Filter; ///< none: Box, but Bilinear to more texels than pixels
  Rank1Boundary Boundary = Rank1Boundary::Periodic;
};

/// Whether parameters are good for any picture, as far as that can be told without one.
bool CheckRank1Parameters(const Rank1ResampleParameters& parameters, std::string& why);

/// Dimensions (n, S, T) by the parameters, all of them counted.
bool FindRank1Dimensions(const Rank1Picture& picture, const Rank1ResampleParameters& parameters,
  int dimensions[3], std::string& why);

/// The lattice of a tile, by the parameters.
std::optional<Rank1Lattice> FindRank1Lattice(
  const Rank1Picture& picture, const Rank1ResampleParameters& parameters, std::string& why);

/// Whether there is an image, a Cartesian picture with number scalars, all of them there.
bool CheckRank1Input(vtkImageData* image, std::string& why);

/// Makes a rank-1 image of all of a picture's pixels: `extent`, a part of its dimensions (n, S, T),
/// is computed, and equals that part of the whole. False where the algorithm, if any, was aborted;
/// its progress runs from begin to end.
bool ResampleToRank1(vtkAlgorithm* self, const Rank1Picture& picture,
  const Rank1ResampleParameters& parameters, const Rank1Lattice& lattice, vtkDataArray* pixels,
  const int extent[6], vtkImageData* output, double begin = 0.0, double end = 1.0);

} // namespace bravais

#endif
