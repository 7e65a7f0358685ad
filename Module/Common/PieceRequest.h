// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceRequest_h
#define PieceRequest_h

#include "vtkBravaisABINamespace.h"

/// \file
/// How a filter whose stencils reach beyond a piece asks for its input. Where numbered pieces are
/// wanted (one for each MPI rank, say), VTK would hand the number on to the input, whose piece has
/// none of its neighbours' samples. So the filter finds out which extent its piece is, and asks for
/// all that this extent needs, as an extent.

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkInformationVector;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// The extent that RequestData is going to be asked for: the update extent or, of a numbered
/// piece, that part of it. Empty where there are more pieces than points.
void GetPieceExtent(vtkInformation* output, int extent[6]);

/// Whether a numbered piece is wanted.
bool IsPiece(vtkInformation* output);

/// Asks for an extent and all of it.
void RequestExtent(vtkInformation* input, const int extent[6]);

/// Asks for all of an input, whatever piece is wanted.
void RequestWholeExtent(vtkInformation* input);

/// For a RequestInformation that fails: empties the output, be it one or many blocks, and tells of
/// no extent, since of a block of many VTK asks for the data all the same.
void RefuseInformation(vtkInformationVector* outputs);

} // namespace bravais

#endif
