# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# What Filters and Rendering share, one class a line.
set(BRAVAIS_COMMON
  vtkBCCLattice
)
