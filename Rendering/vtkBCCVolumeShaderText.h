// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeShaderText
 * @brief   the GLSL of vtkBCCVolumeMapper, put together from the files of GLSL/
 *
 * Nothing here needs OpenGL: text goes in and comes out.
 */

#ifndef vtkBCCVolumeShaderText_h
#define vtkBCCVolumeShaderText_h

#include "BCCKernel.h"
#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct VTKBRAVAIS_EXPORT vtkBCCVolumeShaderText
{
  /// The macro definitions and functions that give EvaluateBoxSpline(): the value and derivatives
  /// of the kernel's spline at a position in lattice coordinates. `volume` is the GLSL expression
  /// of the 3D texture that holds the coefficients of one to four components; where it is empty,
  /// the buffer in_bccCoefficients does (vtkBCCCoefficientBuffer).
  static std::string GetSpline(
    bravais::BCCKernel kernel, int components, const std::string& volume);

  /// What VTK's ray caster uses of it, with these macros defined to 1: bccRayCast.glsl,
  /// bccRay.glsl.
  static std::string GetRayCast(const std::vector<std::string>& macros);

  /// The text that starts a ray's samples, unless isosurfaces are refined, and what is written out
  /// beside its colour.
  static std::string GetRayInit();
  static std::string GetExit();

  /// BCCFindPixelRay(), which finds a pixel's ray without VTK's box.
  static std::string GetPixelRay();

  /// The geometry shader that has each fragment of a viewport start a ray.
  static std::string GetSmallPicture();

  /// What takes the place of JitterStatement in VTK's shader: rays start where Bayer has them
  /// start.
  static std::string GetBayerJitter();
  static const char* const JitterStatement;

  /// The region of cropping that a point is in.
  static std::string GetCropping();

  /// Colours of slices of several independent components.
  static std::string GetComponents();

  /// Shading by a headlight alone.
  static std::string GetHeadlight();

  /// Values of a mask, which may be on a lattice, and labels if it is a label map.
  static std::string GetMask(bool lattice, bool labels);

  /// Indices of picked samples, after GetMask if there is one.
  static std::string GetPicking(bool latticeMask);

  /// What ends a pass that reads 24 bits of such an index, the lower or the higher ones; it is the
  /// sample nearest to a refined surface, or to where the ray has ended.
  static std::string GetPickedPoint(bool refined, bool higher);

  /// Leaps over empty bricks, which for an extremum are those that do not get as far, and the text
  /// that makes them before a sample.
  static std::string GetSkipping(bool extremum);
  static std::string GetSkippingImplementation();

  /// The part of rays that a piece of a volume has, the text that goes to it, and what is before a
  /// sample. Refined isosurfaces need only the first.
  static std::string GetPiece();
  static std::string GetPieceInit();
  static std::string GetPieceImplementation();

  /// FindRoot(), which needs a BCCDifference().
  static std::string GetFindRoot();

  /// Isosurfaces at refined roots: the texts that go to VTK's tags.
  static std::string GetIsoSurfaceDeclarations();
  static std::string GetIsoSurfaceDepth();
  static std::string GetIsoSurfaceInit();
  static std::string GetIsoSurfaceImplementation();
  static std::string GetIsoSurfaceTermination();
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeShaderText.h
