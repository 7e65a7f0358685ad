// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRank1TextureInput
 * @brief   a rank-1 image or pyramid as a shader wants it
 *
 * Checks the texture, finds each level's numbers for the shader, and where its texels go in a 2D
 * texture: in index order, tile after tile, each level from the start of a row on. Rows have 2^k
 * texels, 4096 or as many as OpenGL takes, fewer for small textures.
 */

#ifndef vtkRank1TextureInput_h
#define vtkRank1TextureInput_h

#include "Rank1TextureLevels.h"
#include "vtkBravaisABINamespace.h"

#include "vtkBravaisModule.h" // For export macro
#include "vtkTimeStamp.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataObject;

class VTKBRAVAIS_EXPORT vtkRank1TextureInput
{
public:
  /// The levels of a texture whose texels can be drawn, or why it has none. Looks again only where
  /// the texture is another one or has changed.
  bool SetSource(vtkDataObject* texture, std::string& why);

  /// Places the texels, if they fit a texture of so many texels on a side; else says why not.
  bool Fold(int maximumSize, std::string& why);

  /// The time at which the texture or anything of it changed last: a multi-block data set does not
  /// tell of its blocks.
  static vtkMTimeType GetTime(vtkDataObject* texture);

  /// Constants of GLSL that rank1Texture.glsl and rank1LookUp.glsl need, after Fold. They are no
  /// uniforms, which cost a software renderer half of a look-up.
  std::string GetConstants() const;

  bravais::Rank1TextureLevels Levels;
  std::vector<vtkDataArray*> Texels; ///< of each level
  int Components = 0;
  bool Translucent = false; ///< Some texel's opacity is below 1.
  bool PowerOfTwo = false;  ///< The n of each level is a power of two.
  bool Tiled = false;
  vtkTimeStamp LoadTime; ///< when all this was found

  int Log2Columns = 0; ///< of the folded texture
  int Rows = 0;
  std::vector<int> FirstRows; ///< of each level

private:
  bool Load(vtkDataObject* texture, std::string& why);
  bool CheckTexels(std::string& why) const;
  bool AddLevel(std::size_t level, std::string& why);
  bool IsTranslucent() const;

  using Numbers = std::vector<std::array<float, 4>>;
  Numbers ToBasis;
  Numbers Index;
  Numbers Shares;
  Numbers Basis;
  Numbers Shape;
  float Density[2] = { 1, 1 };

  vtkDataObject* Source = nullptr; // compared only
  vtkMTimeType SourceTime = 0;
  std::string Refusal;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkRank1TextureInput.h
