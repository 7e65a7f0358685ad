# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# The maths, one name a line for <Name>.h and <Name>.cxx. No VTK header here.
set(BRAVAIS_CORE
  BCCLattice
)
