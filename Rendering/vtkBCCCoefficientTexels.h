// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCCoefficientTexels
 * @brief   the spline coefficients of a BCC volume, packed for one 3D texture
 *
 * The even coset fills the lower half of the texture's slices and the odd coset the upper half,
 * each as the Cartesian grid it is, so that linear texture filtering blends neighbours of one
 * coset. Lattice point (X, Y, Z) is texel
 *
 *   (X >> 1, Y >> 1, Z >> 1) + Halo + (0, 0, (Z & 1) CosetDepth).
 *
 * Each coset has a halo of two texels on every side, filled by the mirrors of the volume's
 * boundary: every stencil of every kernel at every point of the box stays inside, and shaders need
 * not mirror. Coordinates are those of vtkBCCVolumeFrame.
 */

#ifndef vtkBCCCoefficientTexels_h
#define vtkBCCCoefficientTexels_h

#include "vtkBravaisABINamespace.h"
#include "vtkBravaisModule.h" // For export macro

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
struct vtkBCCVolumeFrame;

class VTKBRAVAIS_EXPORT vtkBCCCoefficientTexels
{
public:
  static constexpr int Halo = 2;

  /// Size of the texture of a volume: along z that of both cosets.
  static glm::ivec3 GetSize(const vtkBCCVolumeFrame& frame);

  /// Packs an array of float or double coefficients, one tuple a point of the volume.
  void Pack(const vtkBCCVolumeFrame& frame, vtkDataArray* coefficients);

  /// Rounds all values to half floats. Returns the largest difference of each component that makes:
  /// infinity where a finite value is too large.
  std::vector<double> RoundToHalf();

  /// Number of values, without those in the end that do not count.
  std::int64_t GetCount() const
  {
    return std::int64_t{ this->Size.x } * this->Size.y * this->Size.z * this->Components;
  }

  glm::ivec3 Size = glm::ivec3(0);
  int Components = 0;
  /// x fastest, components interleaved. Some more in the end that do not count: four
  /// values from any one on are in two groups of four.
  std::vector<float> Values;

private:
  float* GetTexel(int i, int j, int slice);
  template <class T>
  void PackLayer(const vtkBCCVolumeFrame& frame, const T* coefficients, int z);
  void MirrorInSlice(const vtkBCCVolumeFrame& frame, int z);
  void MirrorSlices(const vtkBCCVolumeFrame& frame);
  int GetSlice(int z) const;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCCoefficientTexels.h
