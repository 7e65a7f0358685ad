// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TexturedPolyDataMapper
 * @brief   draws meshes with textures on rank-1 lattices
 *
 * The first input port takes the mesh, the second one the texture: a rank-1 image or what
 * vtkRank1TexturePyramid makes, the mip levels or the r-set of a picture. The mesh's texture
 * coordinates (u, v) are places in the picture, whose edges are at 0 and 1 and which repeats
 * beyond. Each fragment is coloured by the look-up of vtkRank1TextureSampler, in GLSL: by (u, v) in
 * the lattice's reduced basis and Theorem 2, which needs integer products and, where n is a power
 * of two, a bitwise AND in the place of a division (S. Dammertz, H. Dammertz, A. Keller, H. Lensch:
 * Textures on Rank-1 Lattices, 2009, sections 4, 5.2 and 5.5). Levels are chosen by the screen
 * derivatives of (u, v).
 *
 * As VTK's own textures do, the colour multiplies that of the lit surface: texels of one component
 * are grey, of two grey and opacity, of three RGB, of four RGBA. Bytes are divided by 255, 16-bit
 * unsigned integers by 65535, floating-point texels are what they are. All else is
 * vtkOpenGLPolyDataMapper: lighting, scalars, edges, clipping, picking, shader replacements, and
 * further textures of the actor. (SeamlessU and SeamlessV are for those only.)
 *
 * Example:
 * @code
 * mapper = vtkRank1TexturedPolyDataMapper()
 * mapper.SetInputConnection(plane.GetOutputPort())
 * mapper.SetInputConnection(1, pyramid.GetOutputPort())
 * @endcode
 *
 * All levels are in one 2D texture, the texels of each in index order, folded into rows. It is
 * filled when the texture's data or HalfPrecision change, and nothing is copied but what has to be
 * converted: doubles to floats, floats to half ones. The numbers of its lattices are constants of
 * the shader, which is compiled anew for other lattices, and not for other texels.
 *
 * No mesh, one that has cells but no texture coordinates of two or three components, no texture,
 * one that is no rank-1 image or no such levels, other scalar types, more than 4 components, more
 * than 2^24 texels in a tile, more of them than a texture of the GPU holds, an unknown
 * interpolation or level filter: one error each until something changes, and nothing is drawn. NaN
 * texels are drawn as the GPU likes, and leave the others as they are.
 *
 * @sa vtkRank1ImageResample vtkRank1TexturePyramid vtkRank1TextureSampler
 */

#ifndef vtkRank1TexturedPolyDataMapper_h
#define vtkRank1TexturedPolyDataMapper_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"

#include <memory> // For Internals
#include <string> // For Prepare

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkDataObject;

class VTKBRAVAIS_EXPORT vtkRank1TexturedPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkRank1TexturedPolyDataMapper* New();
  vtkTypeMacro(vtkRank1TexturedPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The texture: the second input port.
   */
  void SetTextureConnection(vtkAlgorithmOutput* output);
  void SetTextureData(vtkDataObject* texture);
  vtkDataObject* GetTextureData();
  ///@}

  ///@{
  /**
   * What is between texels, as in vtkRank1ImageReconstruct: the nearest texel's colour, bilinear
   * interpolation on the fundamental parallelepiped, barycentric on the Delaunay triangle (the
   * default), or the three-direction quartic box-spline, which is smooth and does not interpolate.
   */
  vtkSetMacro(Interpolation, int);
  vtkGetMacro(Interpolation, int);
  void SetInterpolationToNearest() { this->SetInterpolation(0); }
  void SetInterpolationToBilinear() { this->SetInterpolation(1); }
  void SetInterpolationToBarycentric() { this->SetInterpolation(2); }
  void SetInterpolationToBoxSpline() { this->SetInterpolation(3); }
  const char* GetInterpolationAsString();
  ///@}

  ///@{
  /**
   * Which levels of a pyramid are looked up, as in vtkRank1TextureSampler: the nearest one, or a
   * blend of the two (of an r-set four) on either side (Trilinear, the default).
   */
  vtkSetMacro(LevelFilter, int);
  vtkGetMacro(LevelFilter, int);
  void SetLevelFilterToNearestLevel() { this->SetLevelFilter(0); }
  void SetLevelFilterToTrilinear() { this->SetLevelFilter(1); }
  const char* GetLevelFilterAsString();
  ///@}

  ///@{
  /**
   * Whether floating-point texels are kept on the GPU in 16 bits each, with 11 bits of precision
   * and values beyond 65504 clamped to that. Off by default: 32 bits.
   */
  vtkSetMacro(HalfPrecision, bool);
  vtkGetMacro(HalfPrecision, bool);
  vtkBooleanMacro(HalfPrecision, bool);
  ///@}

  /**
   * The time at which the texels on the GPU were put there, 0 before the first rendering.
   */
  vtkMTimeType GetTexelTime() const;

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* other) override;

  /**
   * True also where a texel is not opaque.
   */
  bool HasTranslucentPolygonalGeometry() override;

protected:
  vtkRank1TexturedPolyDataMapper();
  ~vtkRank1TexturedPolyDataMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderTCoord(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkRank1TexturedPolyDataMapper(const vtkRank1TexturedPolyDataMapper&) = delete;
  void operator=(const vtkRank1TexturedPolyDataMapper&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  bool UpdateTexture(std::string& why);
  bool CheckMesh(std::string& why);
  bool Prepare(vtkRenderer* renderer, std::string& why);
  void ReportOnce(const std::string& why);

  int Interpolation = 2;
  int LevelFilter = 1;
  bool HalfPrecision = false;
};
VTK_ABI_NAMESPACE_END

#endif
