// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef AllocationCounter_h
#define AllocationCounter_h

#include <cstddef>

/// \file
/// Counts the bytes that all libraries of this program have allocated, exactly: the program's own
/// malloc and its kin take the place of the C library's.

/// Bytes that are allocated now.
std::size_t GetAllocatedBytes();

/// The most bytes that were allocated at one time since ResetAllocationPeak.
std::size_t GetAllocationPeak();
void ResetAllocationPeak();

#endif
