// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumePiece
 * @brief   which part of a BCC volume an image holds, and which of it it is to show
 *
 * A piece (vtkBCCLattice::MarkPiece) is rendered as if the whole were: rays enter the whole's box,
 * so that their samples are where they are for all pieces, and those in the piece's own part are
 * taken, a half-open box, so that each sample belongs to one piece. The coefficients are those of
 * the samples that the image holds but, where the volume goes on, for the outermost layer that
 * quasi-interpolation needs. Lattice coordinates are the whole's (vtkBCCVolumeFrame).
 */

#ifndef vtkBCCVolumePiece_h
#define vtkBCCVolumePiece_h

#include "vtkBravaisABINamespace.h"
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

struct vtkBCCVolumePiece
{
  /// What an image of the given marks holds, or one that is a whole volume.
  explicit vtkBCCVolumePiece(vtkImageData* image, int prefilter);

  /// Whether nothing is to be shown, and nothing is wrong.
  bool IsEmpty() const;

  /// Whether the extents lie within each other, and hold the whole where the prefilter needs it.
  bool Check(int kernel, int prefilter, std::string& why) const;

  /// Whether there are coefficients for all that is looked up: those that reach within so many
  /// lattice units of the own part, along each axis.
  bool CheckGhosts(const int reach[3], std::string& why) const;

  /// How many layers of samples beyond the own part a look-up needs that reaches so many lattice
  /// units along an axis.
  static int GetGhostLevels(int axis, int reach, int prefilter);

  bool IsPart = false; ///< not all of the whole is held and shown
  int Whole[6];
  int Held[6];
  int Owned[6];
  int Coefficients[6];
  /// The lattice point that is the first even one of the coefficients.
  int Base[3];
  /// The own part; far beyond the volume's box where that ends.
  float Low[3];
  float High[3];
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumePiece.h
