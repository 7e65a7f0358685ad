// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TextureFileWriter
 * @brief   writes the r-set of a picture of any size to a file of tiles
 *
 * Texture on demand (Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, section
 * 5.2, after Peachey): the picture's complete r-set, S / 2^i x T / 2^j tiles of n texels each, goes
 * to one tiled image, one tile of the lattice a tile of the file, and vtkRank1TextureSampler reads
 * the tiles that it needs through a cache of bounded size. The texels are those of
 * vtkRank1TexturePyramid with `Kind` RSet and `Filter` Box.
 *
 * Neither the picture nor the r-set has to fit memory: the input is asked for blocks of rows, once
 * all over for each of the floor(log2 T) + 1 halvings along v, so it should be able to produce
 * pieces. Memory holds a block of rows, `MemoryLimit` megabytes (64) or what the largest texel's
 * cell needs, and a row of the file's tiles. The file has at most four times the base's texels, and
 * some bytes more where n is not a multiple of 256.
 *
 * `NumberOfPoints` is the number n of texels of a tile; with 0, the default, it is 4096, so that a
 * tile of bytes is a page, and `Tiles` (0, 0), the default, are then as many tiles as make as many
 * texels as the input has pixels, powers of two of about square tiles. The other parameters are
 * vtkRank1TexturePyramid's.
 *
 * Input: an image of one layer, of 1 to 4 components or more where the format has them. Scalars are
 * unsigned char, unsigned short or float, which are stored as they are, or double, stored as float.
 * The file's format follows from the name: .tif, or .exr for floats. `Compression` is a name as for
 * vtkOIIOImageWriter; tiles with none are read fastest.
 *
 * Errors, and no file: those of vtkRank1TexturePyramid and vtkOIIOImageWriter, other scalar types,
 * a format without tiles, and an r-set of 2^31 pixels or more along an axis.
 *
 * Example:
 * @code
 * writer = vtkRank1TextureFileWriter()
 * writer.SetFileName("large.tif")
 * writer.SetInputConnection(reader.GetOutputPort())
 * writer.Write()
 * @endcode
 *
 * @sa vtkRank1TextureSampler vtkRank1TexturePyramid
 */

#ifndef vtkRank1TextureFileWriter_h
#define vtkRank1TextureFileWriter_h

#include "vtkAlgorithm.h"
#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <string> // For names and messages

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;

class VTKBRAVAIS_EXPORT vtkRank1TextureFileWriter : public vtkAlgorithm
{
public:
  static vtkRank1TextureFileWriter* New();
  vtkTypeMacro(vtkRank1TextureFileWriter, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryModes
  {
    Periodic,
    Clamp,
    Mirror
  };

  enum Layouts
  {
    Korobov,
    Locality
  };

  /**
   * A picture that is not connected to a pipeline.
   */
  void SetInputData(vtkDataObject* picture);

  ///@{
  /**
   * The file to write. Default "".
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
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
   * Texels of each tile. Default 0: 4096.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Tiles of the base along u and v. Default 0, 0: as many texels as pixels.
   */
  vtkSetVector2Macro(Tiles, int);
  vtkGetVector2Macro(Tiles, int);
  ///@}

  ///@{
  /**
   * Generator of the lattice. Default 0, 0: that of largest minimum distance on a tile's area.
   */
  vtkSetVector2Macro(Generator, vtkIdType);
  vtkGetVector2Macro(Generator, vtkIdType);
  ///@}

  ///@{
  /**
   * Order of the texels, see vtkRank1Lattice. Default Korobov.
   */
  vtkSetClampMacro(Layout, int, Korobov, Locality);
  vtkGetMacro(Layout, int);
  void SetLayoutToKorobov() { this->SetLayout(Korobov); }
  void SetLayoutToLocality() { this->SetLayout(Locality); }
  const char* GetLayoutAsString();
  ///@}

  ///@{
  /**
   * What is beyond the picture's edge, see vtkRank1ImageResample. Default Periodic.
   */
  vtkSetClampMacro(BoundaryMode, int, Periodic, Mirror);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToPeriodic() { this->SetBoundaryMode(Periodic); }
  void SetBoundaryModeToClamp() { this->SetBoundaryMode(Clamp); }
  void SetBoundaryModeToMirror() { this->SetBoundaryMode(Mirror); }
  const char* GetBoundaryModeAsString();
  ///@}

  ///@{
  /**
   * Megabytes (2^20 bytes) of the picture's rows that are held at a time. Default 64.
   */
  vtkSetClampMacro(MemoryLimit, int, 1, 1048576);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /**
   * Writes the file. False after an error or where AbortExecute was set; there is no file then, or
   * an older one.
   */
  bool Write();

protected:
  vtkRank1TextureFileWriter();
  ~vtkRank1TextureFileWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkRank1TextureFileWriter(const vtkRank1TextureFileWriter&) = delete;
  void operator=(const vtkRank1TextureFileWriter&) = delete;

  bool WriteFile(std::string& why);

  std::string FileName;
  std::string Compression;
  vtkIdType NumberOfPoints = 0;
  int Tiles[2] = { 0, 0 };
  vtkIdType Generator[2] = { 0, 0 };
  int Layout = Korobov;
  int BoundaryMode = Periodic;
  int MemoryLimit = 64;
};
VTK_ABI_NAMESPACE_END

#endif
