// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeMapperScene_h
#define VolumeMapperScene_h

/// \file
/// Frames of mappers that show a pair of volumes, timed.

#include "VolumePair.h"

#include <string>
#include <vector>

namespace bravais
{

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
