// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryImageSource
 * @brief   geometry images of a sphere, a bumpy sphere, a torus or a plane
 *
 * A geometry image is a vtkImageData of w x h x 1 points, the gixels, whose field data hold a
 * vtkStringArray `Lattice` with the one value `GeometryImage`, and whose point array `Points`, set
 * as its vectors, holds the xyz of each gixel: a surface sampled on a regular grid, with no need
 * for connectivity. X. Gu, S. J. Gortler, H. Hoppe, "Geometry images", SIGGRAPH 2002.
 *
 * With u = 2 i / (w - 1) - 1 and v = 2 j / (h - 1) - 1 at gixel (i, j), the surfaces are
 *
 * - Sphere (the default): the octahedron |x| + |y| + |z| = 1 unfolded to the square, normalised,
 *   times `Radius`. Each edge of the image folds on itself about its midpoint, and the gixels that
 *   meet there are equal to the last bit. E. Praun, H. Hoppe, SIGGRAPH 2003.
 * - BumpySphere: the same, times 1 + `BumpAmplitude` sin(pi f x) sin(pi f y) sin(pi f z) at
 *   direction (x, y, z), f being `BumpFrequency`.
 * - Torus: about the z-axis, once round the ring along i and once round the tube along j.
 *   The tube's middle is at `Radius`, and `CrossSectionRadius` is the tube's own. First and
 *   last columns are equal, and so are first and last rows.
 * - Plane: (`Radius` u, `Radius` v, 0).
 *
 * all about `Center`. Triangles whose gixels are in anticlockwise order, (i, j), (i + 1, j),
 * (i, j + 1), show their outside. The image's spacing is 1. It is computed in double precision and
 * in parallel; a piece of the extent equals that piece of the whole.
 *
 * Errors, with an empty output: dimensions below 1 x 1, or more gixels than can be counted or kept
 * in memory; a radius, or cross-section, that is not finite and positive; a centre, amplitude or
 * frequency that is not finite.
 *
 * Example:
 * @code
 * source = vtkGeometryImageSource()
 * source.SetShapeToBumpySphere()
 * source.Update()
 * @endcode
 *
 * @sa vtkGeometryImageLocalityMask vtkGeometryImageToPolyData
 */

#ifndef vtkGeometryImageSource_h
#define vtkGeometryImageSource_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <string> // For the check's message

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkGeometryImageSource : public vtkImageAlgorithm
{
public:
  static vtkGeometryImageSource* New();
  vtkTypeMacro(vtkGeometryImageSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    Sphere,
    Torus,
    BumpySphere,
    Plane
  };

  ///@{
  /**
   * The surface. Default Sphere.
   */
  vtkSetClampMacro(Shape, int, Sphere, Plane);
  vtkGetMacro(Shape, int);
  void SetShapeToSphere() { this->SetShape(Sphere); }
  void SetShapeToTorus() { this->SetShape(Torus); }
  void SetShapeToBumpySphere() { this->SetShape(BumpySphere); }
  void SetShapeToPlane() { this->SetShape(Plane); }
  const char* GetShapeAsString();
  ///@}

  ///@{
  /**
   * Width and height in gixels, at least 1, 1. Default 257, 257.
   */
  vtkSetVector2Macro(Dimensions, int);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The surface's middle. Default 0, 0, 0.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * The spheres' radius, that of the torus's ring, or half the plane's side. Default 1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Radius of the torus's tube. Default 0.4.
   */
  vtkSetMacro(CrossSectionRadius, double);
  vtkGetMacro(CrossSectionRadius, double);
  ///@}

  ///@{
  /**
   * How far the bumps reach, as a part of the radius. Default 0.2.
   */
  vtkSetMacro(BumpAmplitude, double);
  vtkGetMacro(BumpAmplitude, double);
  ///@}

  ///@{
  /**
   * Half waves a radius along each axis. Default 3.
   */
  vtkSetMacro(BumpFrequency, double);
  vtkGetMacro(BumpFrequency, double);
  ///@}

  ///@{
  /**
   * Type of the positions, VTK_FLOAT (the default) or VTK_DOUBLE.
   */
  vtkSetClampMacro(OutputScalarType, int, VTK_FLOAT, VTK_DOUBLE);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString();
  ///@}

protected:
  vtkGeometryImageSource();
  ~vtkGeometryImageSource() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGeometryImageSource(const vtkGeometryImageSource&) = delete;
  void operator=(const vtkGeometryImageSource&) = delete;

  bool CheckParameters(std::string& why) const;
  void GetPoint(int i, int j, double x[3]) const;

  int Shape = Sphere;
  int Dimensions[2] = { 257, 257 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 1.0;
  double CrossSectionRadius = 0.4;
  double BumpAmplitude = 0.2;
  double BumpFrequency = 3.0;
  int OutputScalarType = VTK_FLOAT;
};
VTK_ABI_NAMESPACE_END

#endif
