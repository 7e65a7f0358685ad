// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OIIOMetadata_h
#define OIIOMetadata_h

/// \file
/// An image file's metadata are field data of the image, an array for each attribute.

#include "vtkBravaisABINamespace.h"
#include <OpenImageIO/imageio.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// Adds the attributes of a header.
void AddOIIOMetadata(const OIIO::ImageSpec& spec, vtkFieldData* data);

/// Sets a header's attributes, of those arrays that describe the picture and not how a file stored
/// it (tiles, compression, colour handling ...), which is the writer's own.
void SetOIIOMetadata(vtkFieldData* data, OIIO::ImageSpec& spec);

} // namespace bravais

#endif
