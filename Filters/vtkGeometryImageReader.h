// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryImageReader
 * @brief   reads geometry images from .gim, .vti and pictures of floats
 *
 * The output is a geometry image (see vtkGeometryImageSource): `Points`, float or double as the
 * file has it, set as the vectors, and the tag. Which format it is tells the file name's ending:
 *
 * - .gim: two little-endian 32-bit integers, width w and height h, and w x h x 3 32-bit floats,
 * xyz, row after row. Row 0 comes first.
 * - .vti: VTK's own format, of one slice. Images that vtkGeometryImageWriter wrote keep all of
 * their arrays, `Defined` included; of others the vectors, or else the scalars, are the positions,
 * if they are 3 floats or doubles.
 * - .mhd, .mha, .vtk: images that VTK reads, likewise, with the scalars.
 * - any other: pictures of half, float or double that OpenImageIO reads (OpenEXR, TIFF ...).
 * Channels 0 to 2 are x, y, z; row 0 is the lowest, as VTK has it.
 *
 * Gixels at NaN are not used. Of .gim, rows outside the update extent are not read. A header is
 * checked against the size of its file, and for pictures against what their compression can save,
 * before anything is allocated.
 *
 * Errors, with an empty output: no file name; a file that is missing, truncated, longer than its
 * header tells, of another format or number type, or with fewer than 3 channels; more gixels than
 * memory can hold.
 *
 * Example:
 * @code
 * reader = vtkGeometryImageReader()
 * reader.SetFileName("bunny.gim")
 * reader.Update()
 * @endcode
 *
 * @sa vtkGeometryImageWriter vtkGeometryImageSource
 */

#ifndef vtkGeometryImageReader_h
#define vtkGeometryImageReader_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For the open file
#include <string> // For the reasons of failures

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkGeometryImageReader : public vtkImageAlgorithm
{
public:
  static vtkGeometryImageReader* New();
  vtkTypeMacro(vtkGeometryImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file's name. It is read again after Modified().
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkGeometryImageReader();
  ~vtkGeometryImageReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGeometryImageReader(const vtkGeometryImageReader&) = delete;
  void operator=(const vtkGeometryImageReader&) = delete;

  bool Open(std::string& why);
  bool OpenWithVTK(const std::string& ending, std::string& why);
  bool Read(vtkImageData* output, const int extent[6], std::string& why);

  char* FileName = nullptr;

  class Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
