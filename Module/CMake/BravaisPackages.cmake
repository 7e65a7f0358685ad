# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# What the project stands on. Each name here is installed by a line of packages.txt, and the VTK
# modules are those of vtk.module.

set(bravais_vtk_modules
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  ImagingCore RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 glew opengl
  vtksys)
if (BRAVAIS_BUILD_TESTING)
  list(APPEND bravais_vtk_modules CommonMisc IOImage IOXML ImagingSources InteractionStyle
    RenderingFreeType TestingCore TestingRendering)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif ()
if (BRAVAIS_BUILD_EXAMPLES)
  list(APPEND bravais_vtk_modules IOImage IOLegacy IOXML ImagingMorphological
    InteractionStyle RenderingFreeType)
  find_package(CLI11 REQUIRED) # command lines
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
find_path(KISSFFT_INCLUDE_DIR kissfft/kissfft.hh REQUIRED # the spectra of Bayer patterns
  DOC "The folder that holds kissfft/kissfft.hh")
