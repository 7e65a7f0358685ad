// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeFrame
 * @brief   how the box of a BCC volume lies in the world and in texture coordinates
 *
 * VTK's ray caster works in texture coordinates, [0, 1]^3 over the box of the volume. The shaders
 * of vtkBCCVolumeMapper need lattice coordinates there, which run over Low .. High: along x from 0
 * to 2 nx - 1, along y likewise, and along z from the coset of the first layer (0 or 1) on, so that
 * their parity tells the coset in a piece of a volume too.
 *
 * A stand-in is the image VTK is shown instead of the volume: it has the volume's true box as its
 * bounds, and its values on cells, so that VTK shifts nothing by half a texel.
 */

#ifndef vtkBCCVolumeFrame_h
#define vtkBCCVolumeFrame_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

struct VTKBRAVAIS_EXPORT vtkBCCVolumeFrame
{
  /// The frame of a tagged image of at least one point a row and two layers.
  explicit vtkBCCVolumeFrame(vtkImageData* volume);

  /// The frame of another extent of its lattice: the whole of which the image is a piece, or a
  /// part.
  vtkBCCVolumeFrame(vtkImageData* volume, const int extent[6]);

  /// Gives an image the volume's box, direction and number of cells; drops what it holds. With one
  /// cell only, VTK's texture is small: for a piece, whose process has no room for the whole.
  void FitStandIn(vtkImageData* standIn, bool oneCell = false) const;

  /// The extent of a stand-in that has as many cells as samples, Spacing[] each.
  void GetStandInExtent(int extent[6]) const;

  vtkIdType GetNumberOfPoints() const;

  /// What makes the gradient in the volume's own system, direction and all, of derivatives along
  /// lattice coordinates: a matrix by columns.
  void GetGradientMatrix(float matrix[9]) const;

  int Extent[6];
  double Low[3];
  double High[3];
  /// Derivatives of the lattice coordinates along the axes of the volume's own system.
  double LatticePerUnit[3];
  /// The edges of a cell of the stand-in that has as many as samples.
  double Spacing[3];

private:
  double Origin[3]; // The corner where texture coordinates are 0.
  double Direction[9];
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeFrame.h
