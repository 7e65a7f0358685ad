// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OIIOChannels_h
#define OIIOChannels_h

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace bravais
{

/// VTK's scalar type for a type of OpenImageIO, half being float; VTK_VOID for none.
int ToVTKType(OIIO::TypeDesc type);

/// OpenImageIO's type for a scalar type of VTK; UNKNOWN for none.
OIIO::TypeDesc FromVTKType(int type);

/// Channels that are the components of one point array.
struct OIIOChannelArray
{
  std::string Name;
  int Type = 0; ///< VTK's
  std::vector<int> Channels;
};

/// The point arrays that a file's channels become, by the rules of vtkOIIOImageReader. The first
/// are the scalars.
std::vector<OIIOChannelArray> SortOIIOChannels(const OIIO::ImageSpec& spec);

/// Names of a scalar array's components in a file: Y, YA, RGB, RGBA, or channel0 ... for more.
std::vector<std::string> NameOIIOChannels(int components);

} // namespace bravais

#endif
