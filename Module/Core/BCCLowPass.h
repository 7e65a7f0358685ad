// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCLowPass_h
#define BCCLowPass_h

#include "MirrorTransform.h"

#include <glm/vec3.hpp>

#include <vector>

namespace bravais
{

/// Removes from samples on a Cartesian grid the frequencies that a BCC lattice cannot represent.
///
/// Those that it can fill the Voronoi cell of its dual lattice, a rhombic dodecahedron: with nu the
/// frequency in cycles per unit of the lattice coordinates,
///
///     |nu_x| + |nu_y| <= 1/2,  |nu_x| + |nu_z| <= 1/2,  |nu_y| + |nu_z| <= 1/2.
///
/// A box of frequencies, which is all that filters along the axes can cut out, either reaches
/// beyond it or leaves much of it unused. So the samples are transformed, continued by whole-sample
/// mirrors, and their spectrum is multiplied by the response below: memory is the samples' own.
///
/// The work is cut into parts for threads: all parts of pass 0, then of pass 1, then of pass 2.
class BCCLowPass
{
public:
  /// For so many samples along each axis (at least 2), `step` lattice coordinates apart.
  BCCLowPass(const glm::ivec3& dimensions, const glm::dvec3& step);

  /// Gain at a frequency in cycles per lattice coordinate: a product over the three pairs of axes
  /// that is 1 where |nu_a| + |nu_b| is up to 0.4, falls by half a cosine, and is 0 from 1/2 on.
  static double GetResponse(const glm::dvec3& frequency);

  static constexpr int NumberOfPasses = 3;
  int GetNumberOfParts(int pass) const
  {
    return pass == 1 ? this->Dimensions.y : this->Dimensions.z;
  }

  /// One part, in place in all of the samples, x fastest. T is float or double.
  template <class T>
  void Apply(int pass, int part, T* samples) const;

private:
  template <class T>
  void TransformLayer(bool forward, T* layer) const;
  template <class T>
  void FilterSlab(int j, T* samples) const;

  glm::ivec3 Dimensions;
  glm::dvec3 Step;
  std::vector<MirrorTransform> Transforms; // one an axis
};

} // namespace bravais

#endif
