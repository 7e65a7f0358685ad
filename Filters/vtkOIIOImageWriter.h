// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOIIOImageWriter
 * @brief   writes image files of any format that OpenImageIO has
 *
 * The format follows from the file name's extension: .exr, .tif, .png, .jpg, .hdr and more. The
 * point scalars become the channels: Y, Y A, R G B, or R G B A, and channel0, channel1 ... for more
 * than four components. As with VTK's own writers y points up, so that row 0 is the file's last. A
 * volume is written slice by slice, to files named by `FilePrefix` and `FilePattern`, as by
 * vtkImageWriter; memory is asked for a slice at a time.
 *
 * Numbers are stored as they are: a scalar type or number of components that the format does not
 * have is an error, and never converted. `ScalarType` Half makes numbers half, rounded to nearest;
 * Automatic, the default, does so where the input's field data has `FileScalarType` = half, as
 * vtkOIIOImageReader leaves it, and every value is a half, so that nothing is lost; and Input
 * never. Opacity is stored as it is, and the colour space is not converted. Field data that
 * vtkOIIOImageReader read as metadata, single strings and numbers, are written as such where the
 * format has room for them.
 *
 * `Compression` is OpenImageIO's name of a method, with a quality after a colon where it has one:
 * "zip", "piz", "dwaa:45", "lzw", "jpeg:90"; empty is the format's default, and JPEG's quality of
 * 98 is among those. `TileSize` above 0 makes tiles, which OpenImageIO's cache reads one by one.
 *
 * A file is complete or is not there: it is written under another name beside its own and then
 * takes the place of an older one. Errors, with no file: no file name, no point scalars, a format
 * that is unknown or lacks the type, the number of components, tiles or the compression, or whose
 * files OpenImageIO does not read as they were written (a small picture is tried: 64 bits in tiles of
 * TIFF, opacity in GIF and WebP), integers in RLA, a folder that cannot be written, and a volume
 * without FilePrefix.
 *
 * Example:
 * @code
 * writer = vtkOIIOImageWriter()
 * writer.SetFileName("picture.exr")
 * writer.SetScalarTypeToHalf()
 * writer.SetInputConnection(reader.GetOutputPort())
 * writer.Write()
 * @endcode
 *
 * @sa vtkOIIOImageReader vtkRank1TextureFileWriter
 */

#ifndef vtkOIIOImageWriter_h
#define vtkOIIOImageWriter_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageWriter.h"

#include <string> // For names and messages

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class VTKBRAVAIS_EXPORT vtkOIIOImageWriter : public vtkImageWriter
{
public:
  static vtkOIIOImageWriter* New();
  vtkTypeMacro(vtkOIIOImageWriter, vtkImageWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ScalarTypes
  {
    Automatic,
    Input,
    Half
  };

  ///@{
  /**
   * The type that numbers have in the file. Default Automatic.
   */
  vtkSetClampMacro(ScalarType, int, Automatic, Half);
  vtkGetMacro(ScalarType, int);
  void SetScalarTypeToAutomatic() { this->SetScalarType(Automatic); }
  void SetScalarTypeToInput() { this->SetScalarType(Input); }
  void SetScalarTypeToHalf() { this->SetScalarType(Half); }
  const char* GetScalarTypeAsString();
  ///@}

  ///@{
  /**
   * Name of the compression. Default "", the format's own.
   */
  vtkSetStdStringFromCharMacro(Compression);
  vtkGetCharFromStdStringMacro(Compression);
  ///@}

  ///@{
  /**
   * Width and height of tiles in pixels. Default 0, 0: whole rows.
   */
  vtkSetVector2Macro(TileSize, int);
  vtkGetVector2Macro(TileSize, int);
  ///@}

  /**
   * Writes the file, or a file a slice. GetErrorCode() tells whether that went well.
   */
  void Write() override;

protected:
  vtkOIIOImageWriter() = default;
  ~vtkOIIOImageWriter() override = default;

private:
  vtkOIIOImageWriter(const vtkOIIOImageWriter&) = delete;
  void operator=(const vtkOIIOImageWriter&) = delete;

  void Fail(unsigned long code, const std::string& why);
  std::string GetSliceName(int slice) const;
  bool WriteSlice(
    vtkImageData* image, const int extent[6], const std::string& name, std::string& why);

  int ScalarType = Automatic;
  std::string Compression;
  int TileSize[2] = { 0, 0 };
};
VTK_ABI_NAMESPACE_END

#endif
