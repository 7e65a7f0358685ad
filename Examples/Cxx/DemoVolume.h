// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DemoVolume_h
#define DemoVolume_h

/// \file
/// The demo's pictures of a volume: a BCC one, and a Cartesian one of as many samples beside it.

#include "CommandLine.h"

class Gallery;
class vtkImageData;

struct DemoOptions
{
  VolumeOptions Volume;
  View Look;
  View Detail;
  double Inner = 0.0; ///< isovalue of what is inside, such as bone
  double Outer = 0.0; ///< isovalue of what is about it, such as skin
};

/// How many pictures DrawVolume() draws.
constexpr int VolumePictures = 6;

bool DrawVolume(
  Gallery& gallery, vtkImageData* image, const DemoOptions& options, std::string& why);

#endif
