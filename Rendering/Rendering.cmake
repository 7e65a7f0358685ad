# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Mappers and textures, one class a line.
set(BRAVAIS_RENDERING
  vtkBCCVolumeMapper
  vtkRank1TexturedPolyDataMapper
)

# What they are made of, not installed, one name a line for <Name>.h and <Name>.cxx.
set(BRAVAIS_RENDERING_PRIVATE
  vtkBCCBrickMarks
  vtkBCCBrickTexture
  vtkBCCCoefficientArray
  vtkBCCCoefficientBuffer
  vtkBCCCoefficientTexels
  vtkBCCDepthWatch
  vtkBCCPictureState
  vtkBCCPieceSampling
  vtkBCCProgress
  vtkBCCProgressiveFrame
  vtkBCCRenderChecks
  vtkBCCShaderCheck
  vtkBCCShaderOptions
  vtkBCCVolumeFrame
  vtkBCCVolumeInput
  vtkBCCVolumeMask
  vtkBCCVolumePiece
  vtkBCCVolumeRays
  vtkBCCVolumeShaderStage
  vtkBCCVolumeShaderText
  vtkRank1ShaderText
  vtkRank1TexelTexture
  vtkRank1TextureInput
)

# Shader files of GLSL/, one <Name> a line for GLSL/<Name>.glsl.
set(BRAVAIS_SHADERS
  bayerJitter
  bcc4Polynomial
  bcc7Polynomial
  bcc8Polynomial
  bccBoxSpline
  bccBricks
  bccCubicSpline
  bccDepthWatch
  bccExtremum
  bccFindRoot
  bccFrame
  bccGrazing
  bccIsoSurfaceDec
  bccIsoSurfaceImpl
  bccIsoSurfaceInit
  bccIsoSurfaceNext
  bccIsoSurfaceTerminate
  bccLookAhead
  bccMask
  bccNearest
  bccNothing
  bccNowhere
  bccPicking
  bccPiece
  bccPieceEnter
  bccPieceImpl
  bccPixelRay
  bccRay
  bccRayCast
  bccShowFirst
  bccShowFirstPoints
  bccShowTraced
  bccSkip
  bccSkipImpl
  bccSmallPicture
  bccVolume
  rank1BoxSpline
  rank1Footprint
  rank1FragmentDec
  rank1FragmentImpl
  rank1GeometryDec
  rank1GeometryImpl
  rank1Index
  rank1Interpolation
  rank1Level
  rank1LookUp
  rank1Texture
  rank1VertexDec
  rank1VertexImpl
)
