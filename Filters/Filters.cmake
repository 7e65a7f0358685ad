# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Sources and filters, one class a line.
set(BRAVAIS_FILTERS
  vtkBCCInterpolator
  vtkBCCPrefilter
  vtkBCCVolumeSource
  vtkBCCVolumeToImage
  vtkBayerPattern
  vtkGeometryImageLocalityMask
  vtkGeometryImageReader
  vtkGeometryImageSource
  vtkGeometryImageToPolyData
  vtkGeometryImageWriter
  vtkImageToBCCVolume
  vtkOIIOImageReader
  vtkOIIOImageWriter
  vtkOrderedDither
  vtkPolyDataToGeometryImage
  vtkRank1ImageReconstruct
  vtkRank1ImageResample
  vtkRank1ImageToPolyData
  vtkRank1TextureFileWriter
  vtkRank1TexturePyramid
  vtkRank1TextureSampler
)

# What they are made of and nobody else needs, one name a line for <Name>.h and <Name>.cxx.
set(BRAVAIS_FILTERS_PRIVATE
  BCCGridSampler
  BCCPlacement
  BCCResample
  BCCSplineVolume
  BCCSubset
  CullVolume
  FloatImageFile
  GeometryHierarchy
  GimFile
  GixelSurface
  LayerSampler
  LocalityQuery
  MeshSamples
  OIIOChannels
  OIIOImageFile
  OIIOImageFiller
  OIIOImageSink
  OIIOMetadata
  PictureRows
  Rank1Levels
  Rank1Polygons
  Rank1Resample
  Rank1Texels
  Rank1TileFile
  Rank1TileRows
  WholeJPEG
)
