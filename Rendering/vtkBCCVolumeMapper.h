// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeMapper
 * @brief   ray casting of volumes on the body-centred cubic lattice, on the GPU
 *
 * The input is a BCC volume (vtkBCCLattice) of one to four components. What is rendered is the
 * spline
 *
 *   s(x) = sum over lattice points j of c(j) M(x - j),
 *
 * M the box-spline `Kernel` and c the samples after `Prefilter`, over the volume's whole box, which
 * is half a spacing more along x and y than vtkImageData's own bounds. The four kernels are
 * evaluated in the shader from 4, 30, 32 or 128 coefficients (M. Kim and Y. Lee, Real-time BCC
 * Volume Isosurface Ray Casting on the GPU), kept in one 3D texture of floats, both cosets packed
 * densely with a halo of two texels.
 *
 * All else is VTK's own mapper: transfer functions, shading, blend modes, cropping, clipping, depth
 * and picking are used as in vtkGPUVolumeRayCastMapper. It is told the range of the samples, which
 * the spline may exceed. vtkVolumeProperty's interpolation type matters to transfer functions only:
 * the kernel interpolates.
 *
 * Example:
 * @code
 * mapper = vtkBCCVolumeMapper()
 * mapper.SetKernelToBCC7()
 * mapper.SetInputConnection(source.GetOutputPort())
 * volume = vtkVolume()
 * volume.SetMapper(mapper)
 * @endcode
 *
 * An input that is not a tagged image, is empty or has fewer than two layers, has no point scalars,
 * no finite value or more than four components, a texture larger than OpenGL takes, an unknown
 * kernel, prefilter or pattern, or two that do not go together: one error each until something
 * changes, and nothing is rendered. NaN samples spread as far as prefilter and kernel reach, and
 * leave holes.
 *
 * A piece of a volume with ghosts (vtkBCCLattice::MarkPiece, and MarkWholeRange for colours) shows
 * its own part as it is in a picture of the whole: rays are sampled at the same places, and each
 * sample belongs to one piece. So pictures of all pieces, blended front to back, are the whole's
 * but for the rounding of colours, and so are surfaces without a seam; sample distances are not
 * adjusted to the time at hand. Maximum, minimum, average and additive blending of a part are that
 * part's, and do not become the whole's by such blending. A piece with fewer ghosts than
 * GetNumberOfGhostLevels() along an axis that is cut, or of which a prefilter needs the whole
 * (Interpolation but for BCC4, Projection), is an error; an empty one shows nothing.
 *
 * Several inputs at once (vtkMultiVolume), partitions and the depth pass of
 * vtkGPUVolumeRayCastMapper, which know Cartesian grids only, are refused in the same way.
 *
 * @sa vtkBCCLattice vtkBCCVolumeToImage vtkGPUVolumeRayCastMapper
 */

#ifndef vtkBCCVolumeMapper_h
#define vtkBCCVolumeMapper_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkCommand.h"       // For UserEvent
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <memory> // For Internals
#include <string> // For Prepare

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCProgressiveFrame;
class vtkImageData;
class vtkShaderProperty;
struct vtkBCCVolumeFrame;

class VTKBRAVAIS_EXPORT vtkBCCVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkBCCVolumeMapper* New();
  vtkTypeMacro(vtkBCCVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The kernel that samples are reconstructed with, one of vtkBCCLattice::Kernels: BCC7 by default.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  void SetKernelToBCC4() { this->SetKernel(4); }
  void SetKernelToBCC7() { this->SetKernel(7); }
  void SetKernelToBCC8() { this->SetKernel(8); }
  void SetKernelToBCC12() { this->SetKernel(12); }
  const char* GetKernelAsString();
  ///@}

  ///@{
  /**
   * How samples become coefficients: as they are (None), by quasi-interpolation (the default), so
   * that the spline passes through the samples (Interpolation, with BCC4 and BCC8 only), or by the
   * orthogonal projection of the band-limited signal. Done when data, kernel or this changes.
   */
  vtkSetMacro(Prefilter, int);
  vtkGetMacro(Prefilter, int);
  void SetPrefilterToNone() { this->SetPrefilter(0); }
  void SetPrefilterToQuasiInterpolation() { this->SetPrefilter(1); }
  void SetPrefilterToInterpolation() { this->SetPrefilter(2); }
  void SetPrefilterToProjection() { this->SetPrefilter(3); }
  const char* GetPrefilterAsString();
  ///@}

  ///@{
  /**
   * Whether shading and gradient opacity use the derivative of the spline, from the coefficients of
   * its value, or VTK's differences of six more values. On by default. Where clipped voxels are
   * given an intensity (vtkVolumeProperty::UseClippedVoxelIntensity) it is always differences.
   */
  vtkSetMacro(AnalyticGradients, bool);
  vtkGetMacro(AnalyticGradients, bool);
  vtkBooleanMacro(AnalyticGradients, bool);
  ///@}

  ///@{
  /**
   * Whether rays leap over bricks of the volume in which nothing can be seen. On by default. The
   * picture is the same, to the bit. Each brick of 5^3 lattice units has the least and the largest
   * coefficient that reaches into it, which bound the spline. From these is known where opacity is
   * 0 (composite and additive blending) or no isovalue is met, and at what distance the next brick
   * is that matters; maximum and minimum intensity compare them with what the ray has found, or
   * with what it will find where they promise most.
   * Nothing is left out in average and slice blending, with label maps, in minimum intensity of
   * several components, or with dependent components but the last one's opacity. On the GPU it
   * takes one byte a brick.
   */
  vtkSetMacro(EmptySpaceSkipping, bool);
  vtkGetMacro(EmptySpaceSkipping, bool);
  vtkBooleanMacro(EmptySpaceSkipping, bool);
  ///@}

  ///@{
  /**
   * Whether coefficients are kept as half floats on the GPU, in half of the memory. Off by default.
   * The kernels are not negative and sum to 1, so no value changes by more than the largest change
   * of a coefficient, GetCoefficientError(), in the samples' units: 2^-11 of the largest
   * coefficient at most. If that exceeds 1/512 of a component's range, as it may where values have
   * a large offset or Projection for BCC12 has large coefficients, there is an error and nothing is
   * rendered.
   */
  vtkSetMacro(HalfFloatCoefficients, bool);
  vtkGetMacro(HalfFloatCoefficients, bool);
  vtkBooleanMacro(HalfFloatCoefficients, bool);
  double GetCoefficientError() const;
  ///@}

  /**
   * If this is called, a volume whose coefficients take more bytes on the GPU than this times
   * MaxMemoryFraction gets an error and is not rendered. VTK's default, a guess, limits nothing.
   */
  void SetMaxMemoryInBytes(vtkIdType bytes) override;

  ///@{
  /**
   * Bytes of the coefficients and of the bricks of EmptySpaceSkipping on the GPU, as last rendered.
   */
  vtkIdType GetCoefficientMemory() const;
  vtkIdType GetBrickMemory() const;
  ///@}

  ///@{
  /**
   * In isosurface blending, whether surfaces are shaded at the spline's roots, found between
   * samples on either side of an isovalue, or by VTK at the sample after. On by default. Refined
   * surfaces are composited front to back, jitter does not move them, cropping and masks cut them
   * without closing the cuts, and the depth of the first visible one is what the depth image tells.
   * It is written into the depth buffer too, where surfaces have added up to opaque, or in a
   * selection as soon as they are visible, unless another render pass decides on the depth buffer.
   */
  vtkSetMacro(IsoSurfaceRefinement, bool);
  vtkGetMacro(IsoSurfaceRefinement, bool);
  vtkBooleanMacro(IsoSurfaceRefinement, bool);
  ///@}

  ///@{
  /**
   * Where along a ray its first sample lies. None (the default): a whole sample distance from where
   * the ray enters. VTK: a fraction of it, from VTK's noise texture; this is what UseJittering of
   * the superclass says, which is on exactly if the pattern is VTK. Bayer: (rank + 1/2) / 64 of it,
   * with the rank of the viewport's pixel in the square of vtkBayerPattern of 8 x 8 pixels, so that
   * pictures are stable and any 2 x 2 or 4 x 4 pixels together have evenly spaced samples. Both
   * turn rings of samples that are too far apart into a grain. Slices are not sampled along rays.
   */
  void SetJitterPattern(int pattern);
  vtkGetMacro(JitterPattern, int);
  void SetJitterPatternToNone() { this->SetJitterPattern(0); }
  void SetJitterPatternToVTK() { this->SetJitterPattern(1); }
  void SetJitterPatternToBayer() { this->SetJitterPattern(2); }
  const char* GetJitterPatternAsString();
  void SetUseJittering(vtkTypeBool use) override;
  ///@}

  ///@{
  /**
   * Gives Bayer's jitter to a volume of vtkOpenGLGPUVolumeRayCastMapper, by a shader replacement in
   * the volume's shader property, or takes it away. UseJittering has to be off there.
   */
  static void AddBayerJitter(vtkShaderProperty* property);
  static void RemoveBayerJitter(vtkShaderProperty* property);
  ///@}

  ///@{
  /**
   * Whether a picture is traced in passes, one for each call of Render(). Off by default. The
   * viewport is cut into blocks of ProgressivePatternSize squared pixels, sides of 2, 4 (the
   * default) or 8; each pass traces one ray of every block, in the order of vtkBayerPattern, and
   * costs that fraction of a frame. Pixels that are not traced yet show the nearest that is. It
   * starts anew if camera, viewport, data, lights, or any property of volume and mapper changes, or
   * the depth of what is in front; so moving pictures are coarse. After the last pass the picture
   * is the plain one, bit by bit, at the sample distance of a frame that has all the time: it is
   * not adjusted to the time at hand. Each viewport keeps 16 bytes for each of its pixels, 20 if
   * surfaces write depths.
   *
   * Whoever wants it completed keeps on calling Render() of the window until GetProgressComplete(),
   * which is true if the pictures drawn last, of all viewports and volumes that this mapper is
   * shown in, have all their rays. When it becomes true at the end of a pass, ProgressCompleteEvent
   * is invoked; from within no picture can be rendered.
   *
   * Drawn at once and complete are pictures with an ImageSampleDistance other than 1, those of
   * other render passes, such as depth peeling of volumes, and RenderToImage's. Selections and
   * canonical views are drawn at once too, and leave the passes alone.
   */
  vtkSetMacro(ProgressiveRefinement, bool);
  vtkGetMacro(ProgressiveRefinement, bool);
  vtkBooleanMacro(ProgressiveRefinement, bool);
  vtkSetMacro(ProgressivePatternSize, int);
  vtkGetMacro(ProgressivePatternSize, int);
  bool GetProgressComplete() const;
  enum
  {
    ProgressCompleteEvent = vtkCommand::UserEvent + 1
  };
  ///@}

  /**
   * How many layers of samples a piece of a volume of this spacing needs beyond its own part, where
   * the volume goes on, with the kernel, prefilter, gradients and sample distance as they are, for
   * every blend mode: the most of all axes. For BCC7 with QuasiInterpolation it is 6. A volume that
   * is scaled has larger sample distances, by up to `scale`, where they are adjusted automatically.
   */
  int GetNumberOfGhostLevels(const double spacing[3], double scale = 1.0);

  /**
   * The time at which the coefficients in use were computed, 0 before the first rendering.
   */
  vtkMTimeType GetCoefficientTime() const;

  using Superclass::GetBounds;
  /**
   * The volume's box, in the volume's own system; of a piece that of its own part.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;

  using Superclass::Update;
  void Update() override;
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * A BCC volume cannot be cut into partitions: an error if there is to be more than one.
   */
  void SetPartitions(unsigned short x, unsigned short y, unsigned short z);

protected:
  vtkBCCVolumeMapper();
  ~vtkBCCVolumeMapper() override;

private:
  vtkBCCVolumeMapper(const vtkBCCVolumeMapper&) = delete;
  void operator=(const vtkBCCVolumeMapper&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  bool Prepare(vtkRenderer* renderer, vtkVolume* volume, std::string& why);
  void ReportOnce(const std::string& why);
  float FindSampleDistance(const vtkBCCVolumeFrame& frame, vtkVolume* volume);
  bool CheckPiece(vtkVolume* volume, vtkImageData* image, std::string& why);

  void ShowStandIn(vtkRenderer* renderer, vtkVolume* volume);
  void RenderPiece(vtkRenderer* renderer, vtkVolume* volume);

  bool IsShown(vtkRenderer* renderer) const;
  bool IsTracedInPasses(vtkRenderer* renderer, vtkVolume* volume) const;
  vtkBCCProgressiveFrame* StartPass(vtkRenderer* renderer, vtkVolume* volume, bool depth);
  void FinishPass(vtkRenderer* renderer, vtkVolume* volume, vtkBCCProgressiveFrame* frame);

  int Kernel = 7;
  int Prefilter = 1;
  bool AnalyticGradients = true;
  bool EmptySpaceSkipping = true;
  bool HalfFloatCoefficients = false;
  bool MemoryIsLimited = false;
  bool IsoSurfaceRefinement = true;
  int JitterPattern = 0;
  bool ProgressiveRefinement = false;
  int ProgressivePatternSize = 4;
};
VTK_ABI_NAMESPACE_END

#endif
