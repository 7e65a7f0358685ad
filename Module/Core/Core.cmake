# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# The maths, one name a line for <Name>.h and <Name>.cxx. No VTK header here.
set(BRAVAIS_CORE
  AnalyticSignals
  BCCBlock
  BCCBricks
  BCCCoefficientWindow
  BCCFit
  BCCKernel
  BCCLattice
  BCCLowPass
  BCCPaddedLayer
  BCCPrefilter
  BCCQuasiInterpolation
  BCCResponse
  BCCSpectralPrefilter
  BCCSplineRows
  BSplineSampler
  BayerFill
  BayerMeasures
  BayerPattern
  BitMask
  BrickDistances
  CellGrid
  ChirpTransform
  CullOctree
  DiskRim
  FoldedCut
  GixelLevel
  GixelNormals
  GixelOctree
  GixelSampling
  GixelTriangles
  MaskStore
  MeshLayout
  MirrorTransform
  OrderedDither
  ParametricSurface
  Rank1Cells
  Rank1Lattice
  Rank1Resampler
  Rank1Search
  RoaringCode
  RunLengthCode
  SpringEmbedding
  StretchDescent
  StretchRelaxation
  SurfaceParameters
  SurfaceParametrization
  TriangleCleaning
  TriangleSearch
  TriangleTopology
  VolumeTest
)

# Those that are a header only, one <Name>.h a line.
set(BRAVAIS_CORE_HEADERS
  BoxSpline
  CellCoverage
  FindRoot
  FoldedSquare
  Rank1BoxSpline
  Rank1Index
  Rank1Interpolation
  Rank1Level
  Rank1LookUp
  Rank1Sampling
  RoundTo
)

# Parts that these headers include.
set(BRAVAIS_CORE_INLINES
  BCC4Polynomial.inl
  BCC7Polynomial.inl
  BCC8Polynomial.inl
)

# A sum has to round alike in the vectorised and in the remaining columns of a row.
set_source_files_properties(Module/Core/BCCQuasiInterpolation.cxx
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=off")
# Products and sums become fused where the processor can: half the instructions of a polynomial.
set_source_files_properties(Module/Core/BCCSplineRows.cxx
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=fast")
# Bounds of sums hold to the last bit where their terms round as VTK's do.
set_source_files_properties(Module/Core/CellGrid.cxx Module/Core/VolumeTest.cxx
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=off")
# With checks and debug information for each of Highway's instruction sets, that file would compile
# for many minutes.
if (BRAVAIS_SANITIZE)
  set_source_files_properties(Module/Core/BCCSplineRows.cxx PROPERTIES
    COMPILE_OPTIONS "-ffp-contract=fast;-O1;-g1;-fno-var-tracking"
    COMPILE_DEFINITIONS "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4|HWY_AVX3|HWY_AVX3_DL)")
endif ()
