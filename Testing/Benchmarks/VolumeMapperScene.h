// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeMapperScene_h
#define VolumeMapperScene_h

/// \file
/// Pairs of volumes with as many samples on either lattice, and frames of them that are timed.

#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkGPUVolumeRayCastMapper;
class vtkImageData;

namespace bravais
{

/// One function on both lattices, and how it is looked at.
struct VolumePair
{
  std::string Name;
  vtkSmartPointer<vtkImageData> BCC;
  vtkSmartPointer<vtkImageData> Cartesian;
  double IsoValue = 0.0;
  std::vector<std::pair<double, double>> Opacities; ///< scalars and opacities
  int Width = 512;
  int Height = 512;
};

/// The Marschner-Lobb function on n x n x 2n points, and on as many Cartesian ones.
VolumePair MakeMarschnerLobb(int n, int width, int height);

/// A head of ellipsoids in air: skin, bone, brain; dimensions are those of the BCC volume.
VolumePair MakeHead(const std::string& name, const int dimensions[3], int width, int height);

/// A MetaImage file, resampled to a BCC volume of as many samples; its range maps to a head's.
/// Null pointers if it cannot be read.
VolumePair ReadPair(const std::string& path, double isoValue, int width, int height);

/// The mapper of a kernel (4, 7, 8, 12), or VTK's own (0).
struct MapperChoice
{
  std::string Name;
  int Kernel;
  bool Skip;
};

enum class RenderMode
{
  IsoSurface,
  Composite,
  Shaded,
  Maximum
};
const char* GetName(RenderMode mode);

/// Seconds of the frames of one mapper: processor time of all threads, or by the clock.
struct FrameTimes
{
  std::vector<double> Frames; ///< in the order of drawing
  double Fastest = 0.0;       ///< the least of them, since others use the machine too
  double First = 0.0;         ///< of the first frame after a change of the data
  double Memory = 0.0;        ///< bytes of the volume on the GPU, with what is made of it

  /// Median of the ratios to a peer's frames: each with the one that was drawn next to it, so that
  /// it does not matter how fast the machine was just then.
  double GetRatio(const FrameTimes& peer) const;
};

/// Draws frames of several mappers by turns: rays advance by half the edge of a cube with one
/// sample in it.
std::vector<FrameTimes> TimeFrames(const VolumePair& pair, const std::vector<MapperChoice>& choices,
  RenderMode mode, int frames, bool clock);

} // namespace bravais

#endif
