# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# What the project stands on. Each name here is installed by a line of packages.txt, and the VTK
# modules are those of vtk.module.

set(bravais_vtk_modules
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore IOImage IOXML ImagingCore RenderingCore RenderingOpenGL2 RenderingVolume
  RenderingVolumeOpenGL2 glew opengl vtksys)
if (BRAVAIS_BUILD_TESTING AND NOT BRAVAIS_BUILD_PARAVIEW_PLUGIN)
  list(APPEND bravais_vtk_modules CommonMisc FiltersExtraction FiltersGeneral FiltersSources
    ImagingSources InteractionStyle RenderingFreeType TestingCore TestingRendering)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif ()
if (BRAVAIS_BUILD_EXAMPLES)
  list(APPEND bravais_vtk_modules ChartsCore FiltersGeneral FiltersSources IOGeometry IOLegacy
    ImagingMorphological InteractionStyle RenderingContext2D RenderingContextOpenGL2
    RenderingFreeType ViewsContext2D)
  find_package(CLI11 REQUIRED) # command lines
endif ()
if (BRAVAIS_BUILD_PARAVIEW_PLUGIN)
  if (NOT Python3_EXECUTABLE AND EXISTS "/usr/bin/python3")
    set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "ParaView's Python")
  endif ()
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingViews) # brings its own VTK
  list(APPEND bravais_vtk_modules FiltersSources)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${bravais_vtk_modules})

if (BRAVAIS_WRAP_PYTHON)
  # The interpreter has to be the one VTK's own package is installed for, not the first in PATH.
  if (NOT Python3_EXECUTABLE AND EXISTS "${VTK_PREFIX_PATH}/bin/python3")
    set(Python3_EXECUTABLE "${VTK_PREFIX_PATH}/bin/python3" CACHE FILEPATH "VTK's Python")
  endif ()
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(VTK 9.1 REQUIRED COMPONENTS ${bravais_vtk_modules} Python WrappingPythonCore)
endif ()

find_package(glm REQUIRED)     # vectors, in C++ as in GLSL
find_package(hwy REQUIRED)     # SIMD with dispatch at run time
find_package(Eigen3 REQUIRED)  # linear solves
find_package(roaring REQUIRED) # compressed bitmaps
find_package(OpenImageIO REQUIRED) # image files, and tiles of textures larger than memory
# Debian's package names OpenCV's headers, which it neither has nor needs.
get_target_property(bravais_oiio_include OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER bravais_oiio_include EXCLUDE REGEX "opencv")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${bravais_oiio_include}"
  INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${bravais_oiio_include}")
find_path(KISSFFT_INCLUDE_DIR kissfft/kissfft.hh REQUIRED # the spectra of Bayer patterns
  DOC "The folder that holds kissfft/kissfft.hh")
