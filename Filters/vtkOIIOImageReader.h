// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOIIOImageReader
 * @brief   reads image files of any format that OpenImageIO has
 *
 * OpenEXR, TIFF, PNG, JPEG, Radiance HDR, PNM, DPX, TGA, WebP and more. Values are those of the
 * file: the colour space is left as it is, and colours are not multiplied by opacity where the file
 * has them not multiplied. Numbers keep their type, 8 to 64 bits; half becomes float, which holds
 * every half exactly, and vtkOIIOImageWriter makes it half again.
 *
 * As with vtkPNGReader y points up, so that the file's last row is row 0 (vtkTIFFReader needs
 * SetOrientationType(4) for that), and spacing and
 * origin are `DataSpacing` (1) and `DataOrigin` (0). Where the file's pixels are a window of a
 * larger picture, the origin is that window's place in it. `FileLowerLeft` keeps the rows as they
 * are.
 *
 * Channels become point arrays. The active scalars, named `Scalars`, are R, G, B and A where the
 * file has these, or Y and A. The others are arrays of their own, named as the channel is, and
 * channels named layer.x, layer.y ... are the components of one array named layer. Where channels
 * have no names with a meaning, all are components of the scalars. The components' names are the
 * channels'. Channels of one array whose types differ become arrays of their own.
 *
 * Field data, added by a complete update: the file's metadata, as OpenImageIO names them (Artist,
 * Exif:FocalLength, oiio:ColorSpace ...), each an array of its own number type or strings;
 * `FileFormat`, as "openexr"; and `FileScalarType`, as "half". Where `Orientation` says that the
 * file's rows go up, as VTK writes TIFF, they do; other orientations are left to the user.
 *
 * `SubImage` and `MipLevel` choose an image of a file that holds several. Files that are a series
 * (`FileNames`, or `FilePrefix` and `FilePattern`) are the slices of a volume, and so are the
 * layers of a file that has depth. Only what the update extent needs is read, in blocks of rows or
 * tiles, and besides the output memory is used for a block: 8 MB or a row of tiles.
 *
 * A header is believed only as far as the file and the machine's memory can hold what it tells, and
 * the first block is read before the output is allocated. Errors, with an empty output: no file
 * name, a file that is missing, empty, truncated or of no known format, a header that tells of more
 * pixels than that, a SubImage or MipLevel that the file does not have, and slices that differ. The
 * superclass' `MemoryBuffer` is not read.
 *
 * Example:
 * @code
 * reader = vtkOIIOImageReader()
 * reader.SetFileName("picture.exr")
 * reader.Update()
 * @endcode
 *
 * To let vtkImageReader2Factory find it: vtkImageReader2Factory.RegisterReader(reader).
 *
 * @sa vtkOIIOImageWriter vtkPNGReader vtkTIFFReader
 */

#ifndef vtkOIIOImageReader_h
#define vtkOIIOImageReader_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro
#include "vtkImageReader2.h"

#include <memory> // For the open file
#include <string> // For the list of extensions

namespace bravais
{
class OIIOImageFile;
}

VTK_ABI_NAMESPACE_BEGIN
class VTKBRAVAIS_EXPORT vtkOIIOImageReader : public vtkImageReader2
{
public:
  static vtkOIIOImageReader* New();
  vtkTypeMacro(vtkOIIOImageReader, vtkImageReader2);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 2 where the file's header can be read and is believed, else 0. Prints nothing.
   */
  int CanReadFile(VTK_FILEPATH const char* name) override;

  /**
   * The extensions of all formats that OpenImageIO reads here.
   */
  const char* GetFileExtensions() override;
  const char* GetDescriptiveName() override { return "OpenImageIO"; }

  ///@{
  /**
   * Which image of a file that holds several, and which of its levels of resolution. Default 0.
   */
  vtkSetMacro(SubImage, int);
  vtkGetMacro(SubImage, int);
  vtkSetMacro(MipLevel, int);
  vtkGetMacro(MipLevel, int);
  ///@}

  ///@{
  /**
   * How many images the file has, and how many levels the chosen one of them has; 0 where it cannot
   * be read. This opens the file.
   */
  int GetNumberOfSubImages();
  int GetNumberOfMipLevels();
  ///@}

protected:
  vtkOIIOImageReader();
  ~vtkOIIOImageReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkOIIOImageReader(const vtkOIIOImageReader&) = delete;
  void operator=(const vtkOIIOImageReader&) = delete;

  bool OpenSlice(int slice, std::string& why);
  int Fail(const std::string& why, vtkInformationVector* outputVector);

  int SubImage = 0;
  int MipLevel = 0;
  std::unique_ptr<bravais::OIIOImageFile> ImageFile;
  std::string Extensions;
};
VTK_ABI_NAMESPACE_END

#endif
