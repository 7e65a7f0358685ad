// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCBrickMarks
 * @brief   which bricks of a BCC volume can be seen
 *
 * From the bounds of a spline in bricks (bravais::BCCBricks), what a shader needs to leap over the
 * others: one byte a brick, or a byte for each component.
 *
 * Scalars are those that VTK's shader looks functions up with: value times scale plus bias, 0 to 1
 * over the range of the samples. All bounds are taken a little wider, so that rounding in the
 * shader does not decide what is seen.
 */

#ifndef vtkBCCBrickMarks_h
#define vtkBCCBrickMarks_h

#include "vtkBravaisABINamespace.h"
#include <cstdint>
#include <vector>

namespace bravais
{
class BCCBricks;
}

VTK_ABI_NAMESPACE_BEGIN
struct vtkBCCBrickMarks
{
  /// How values of one component become scalars, and where these matter.
  struct Scalars
  {
    int Component = 0;
    float Scale = 1.0f;
    float Bias = 0.0f;
    /// Whether anything is seen at each place of a table of 0 .. 1.
    std::vector<bool> Seen;
  };

  /// Distances to bricks where any of the components is seen, and from these to others
  /// (bravais::FindSignedBrickDistances).
  static std::vector<std::uint8_t> FindDistances(
    const bravais::BCCBricks& bricks, const std::vector<Scalars>& components);

  /// The same of bricks where a component may have any of these values.
  static std::vector<std::uint8_t> FindDistances(
    const bravais::BCCBricks& bricks, const std::vector<double>& values);

  /// Upper bounds of the scalars, or lower ones, in units of 1/255: 0 and 255 stand for all scalars
  /// below 0 and above 1 as well. As many components as the bricks have, and one more where these
  /// are three, of which there are no buffers.
  static std::vector<std::uint8_t> FindBounds(
    const bravais::BCCBricks& bricks, const std::vector<Scalars>& components, bool upper);
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCBrickMarks.h
