// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkBravaisABINamespace_h
#define vtkBravaisABINamespace_h

/// \file
/// The namespace that a VTK from 9.2 on may have been built to keep its classes in, and that ours
/// are in too; none with an older VTK. Forward declarations of VTK's classes have to be within it.

#if __has_include("vtkABINamespace.h")
#include "vtkABINamespace.h"
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
