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

/// Seconds of a frame: processor time of all threads, and by the clock.
struct FrameTime
{
  double Processor = 0.0;
  double Clock = 0.0;
  double FirstProcessor = 0.0; ///< of the first frame after a change of the data
  double FirstClock = 0.0;
  double Memory = 0.0; ///< bytes of the volume on the GPU, with what is made of it
};

/// Draws the frames of one mapper: rays advance by half the edge of a cube with one sample in it.
/// The least of `frames` counts, since others use the machine too.
FrameTime TimeFrames(
  const VolumePair& pair, const MapperChoice& choice, RenderMode mode, int frames);

} // namespace bravais

#endif
