// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeInput
 * @brief   what vtkBCCVolumeMapper makes of its input before anything is rendered
 *
 * An image and the array of it that is to be rendered are checked, prefiltered and packed; the
 * coefficients are kept until image, array, kernel or prefilter change. Each step returns false,
 * and tells why, if what it is given cannot be rendered.
 */

#ifndef vtkBCCVolumeInput_h
#define vtkBCCVolumeInput_h

#include "BCCBricks.h"
#include "vtkBCCCoefficientTexels.h"
#include "vtkBCCVolumeFrame.h"
#include "vtkBCCVolumePiece.h"
#include "vtkBravaisABINamespace.h"

#include "vtkNew.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <optional>
#include <string>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class vtkBCCVolumeInput
{
public:
  vtkBCCVolumeInput();
  ~vtkBCCVolumeInput();

  /// Takes an image and point scalars of it.
  bool SetSource(vtkImageData* image, vtkDataArray* scalars, std::string& why);

  /// Finds out what part of a volume the image is, and whether that is enough for look-ups that
  /// reach so many lattice units beyond it.
  bool SetReach(int kernel, int prefilter, const int reach[3], std::string& why);

  /// Whether the texture fits OpenGL's largest, and coefficients and bricks so many bytes.
  bool CheckTexture(int limit, double bytes, bool halfFloats, std::string& why) const;

  /// Makes coefficients and stand-in, if they are not those of the source already.
  bool Load(int kernel, int prefilter, bool halfFloats, std::string& why);

  /// Bounds of the spline in bricks; computed when they are first asked for after a Load().
  const bravais::BCCBricks& GetBricks();

  /// The box of the samples that the source has, in the lattice coordinates of the whole volume.
  vtkBCCVolumeFrame GetHeldFrame() const;

  /// What makes 0 to 1 of the samples' type, as textures of VTK do for colours; or 0 for types that
  /// VTK makes 0 to 1 of each component's range of.
  float GetNormalizer() const;

  std::optional<vtkBCCVolumeFrame> Frame; ///< Of the whole volume.
  std::optional<vtkBCCVolumePiece> Piece;
  vtkBCCCoefficientTexels Texels;
  vtkNew<vtkImageData> StandIn; ///< What VTK is shown: see vtkBCCVolumeFrame.
  vtkTimeStamp LoadTime;
  double CoefficientError = 0.0; ///< The largest difference that half floats make.

private:
  bool Compute(int kernel, int prefilter, bool halfFloats, std::string& why);
  bool RoundToHalf(vtkDataArray* scalars, std::string& why);

  std::optional<bravais::BCCBricks> Bricks;
  vtkNew<vtkImageData> Source; // with the scalars that are rendered
  std::tuple<vtkImageData*, vtkMTimeType, vtkDataArray*> Current;
  std::tuple<vtkImageData*, vtkMTimeType, vtkDataArray*, int, int, bool> Loaded;
  std::string LoadError; // why the last loading failed
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeInput.h
