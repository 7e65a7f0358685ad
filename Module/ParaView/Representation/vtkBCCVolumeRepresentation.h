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
 * Input is a vtkImageData tagged as BCC (vtkBCCLattice). Any other is shown as nothing, with one
 * error of the mapper that says what was expected.
 */

#ifndef vtkBCCVolumeRepresentation_h
#define vtkBCCVolumeRepresentation_h

#include "vtkBravaisParaViewModule.h" // For export macro
#include "vtkImageVolumeRepresentation.h"

class vtkBCCVolumeMapper;

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
  ///@}

protected:
  vtkBCCVolumeRepresentation();
  ~vtkBCCVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBCCVolumeRepresentation(const vtkBCCVolumeRepresentation&) = delete;
  void operator=(const vtkBCCVolumeRepresentation&) = delete;

  vtkBCCVolumeMapper* GetMapper();
};

#endif
