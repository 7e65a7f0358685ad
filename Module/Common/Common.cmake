# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# What Filters and Rendering share, one class a line.
set(BRAVAIS_COMMON
  vtkBCCLattice
  vtkRank1Lattice
)

# Functions that they share and nobody else needs, one name a line for <Name>.h and <Name>.cxx.
set(BRAVAIS_COMMON_PRIVATE
  BCCChecks
  BCCCoefficients
  GeometryImage
  ImageChecks
  LatticeTag
  PieceRequest
  Rank1Image
  Rank1TextureLevels
  SliceLoop
)
