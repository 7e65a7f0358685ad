// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LatticeTag_h
#define LatticeTag_h

#include "vtkBravaisABINamespace.h"

/// \file
/// The mark that tells of a vtkImageData which lattice its points are on: a vtkStringArray named
/// `Lattice` in its field data that holds one of the names below.

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

inline constexpr const char* BCCTag = "BCC";
inline constexpr const char* Rank1Tag = "Rank1";
inline constexpr const char* GeometryImageTag = "GeometryImage";

/// Marks an image, in place of any other mark.
void TagLattice(vtkImageData* image, const char* tag);

/// Whether a data object is an image with that mark; false for nullptr.
bool HasLatticeTag(vtkDataObject* data, const char* tag);

} // namespace bravais

#endif
