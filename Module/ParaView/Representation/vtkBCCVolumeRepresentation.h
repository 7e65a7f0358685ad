// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeRepresentation
 * @brief   ParaView's "BCC Volume": a volume on the BCC lattice by vtkBCCVolumeMapper
 *
 * ParaView's own representation of image data as volumes, with another mapper: colour map, opacity,
 * shading, blend modes, isosurfaces, slices and cropping are as there. The box that is shown is the
 * lattice's, half a spacing more along x and y than vtkImageData's bounds.
 *
 * Each of several processes renders its piece of the volume, with as many ghosts as the kernel, the
 * prefilter and the distance of samples need, so that no seam shows (vtkBCCLattice::MarkPiece); the
 * ranges of arrays are those of all pieces. ParaView blends the pictures front to back, by the
 * boxes of the pieces. That makes pictures of Composite, Isosurface and Slice. Of the other blend
 * modes no picture of the whole can be made by blending: for them, as for the prefilters
 * Interpolation and Projection, every process asks for the whole volume, and for them the first one
 * shows it alone.
 *
 * Input is a vtkImageData tagged as BCC (vtkBCCLattice). Any other is shown as nothing, with one
 * error of the mapper that says what was expected.
 */

#ifndef vtkBCCVolumeRepresentation_h
#define vtkBCCVolumeRepresentation_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisParaViewModule.h" // For export macro
#include "vtkImageVolumeRepresentation.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCVolumeMapper;
class vtkImageData;

class VTKBRAVAISPARAVIEW_EXPORT vtkBCCVolumeRepresentation : public vtkImageVolumeRepresentation
{
public:
  static vtkBCCVolumeRepresentation* New();
  vtkTypeMacro(vtkBCCVolumeRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Handed to the mapper: see vtkBCCVolumeMapper.
   */
  void SetKernel(int kernel);
  void SetPrefilter(int method);
  void SetSampleDistance(double distance);
  void SetBlendMode(int mode);
  ///@}

protected:
  vtkBCCVolumeRepresentation();
  ~vtkBCCVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void UpdateMapperParameters() override;

private:
  vtkBCCVolumeRepresentation(const vtkBCCVolumeRepresentation&) = delete;
  void operator=(const vtkBCCVolumeRepresentation&) = delete;

  vtkBCCVolumeMapper* GetMapper();

  // What of the volume each process asks for.
  bool IsBlendable() const;
  bool NeedsWhole() const;
  void Ask();

  void MarkPiece(vtkImageData* cache, const int whole[6]);
  void ShareRanges(vtkImageData* cache);

  int Kernel = 7;
  int Prefilter = 1;
  int BlendMode = 0;
  double SampleDistance = 0.0;
  double WholeBounds[6];
};
VTK_ABI_NAMESPACE_END

#endif
