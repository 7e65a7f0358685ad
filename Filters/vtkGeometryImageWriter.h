// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryImageWriter
 * @brief   writes geometry images to .gim, .vti and pictures of floats
 *
 * The formats are those of vtkGeometryImageReader, by the file name's ending. .vti keeps all arrays
 * and the number type; .gim and pictures (.exr and .tif) keep the positions as 32-bit floats, with
 * NaN for gixels that are not used.
 *
 * The file is written under another name beside its own and then takes the place of an older one.
 * Errors, and no file: an input that is no geometry image, no FileName, a file that cannot be
 * written, and a format that would not keep floats. Write() then sets the ErrorCode.
 *
 * Example:
 * @code
 * writer = vtkGeometryImageWriter()
 * writer.SetFileName("sphere.gim")
 * writer.SetInputConnection(source.GetOutputPort())
 * writer.Write()
 * @endcode
 *
 * @sa vtkGeometryImageReader
 */

#ifndef vtkGeometryImageWriter_h
#define vtkGeometryImageWriter_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageWriter.h"

#include <string> // For the reasons of failures

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkGeometryImageWriter : public vtkImageWriter
{
public:
  static vtkGeometryImageWriter* New();
  vtkTypeMacro(vtkGeometryImageWriter, vtkImageWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Updates the input and writes all of it to FileName.
   */
  void Write() override;

protected:
  vtkGeometryImageWriter() = default;
  ~vtkGeometryImageWriter() override = default;

private:
  vtkGeometryImageWriter(const vtkGeometryImageWriter&) = delete;
  void operator=(const vtkGeometryImageWriter&) = delete;

  bool WriteImage(std::string& why);
};
VTK_ABI_NAMESPACE_END

#endif
