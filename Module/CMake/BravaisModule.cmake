# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# The module's half: every class and shader of the library, by the lists that the folders keep.

include(Module/Core/Core.cmake)
include(Module/Common/Common.cmake)
include(Filters/Filters.cmake)
include(Rendering/Rendering.cmake)
set(core_headers ${BRAVAIS_CORE} ${BRAVAIS_CORE_HEADERS})
list(TRANSFORM core_headers APPEND ".h")
list(APPEND core_headers ${BRAVAIS_CORE_INLINES})
list(TRANSFORM core_headers PREPEND "Module/Core/")
list(TRANSFORM BRAVAIS_COMMON PREPEND "Module/Common/")
list(TRANSFORM BRAVAIS_COMMON_PRIVATE PREPEND "Module/Common/")
list(TRANSFORM BRAVAIS_FILTERS PREPEND "Filters/")
list(TRANSFORM BRAVAIS_FILTERS_PRIVATE PREPEND "Filters/")
list(TRANSFORM BRAVAIS_RENDERING PREPEND "Rendering/")
list(TRANSFORM BRAVAIS_RENDERING_PRIVATE PREPEND "Rendering/")

# Each GLSL/<Name>.glsl becomes the string <Name>_glsl of header <Name>_glsl.h.
set(shader_sources)
foreach (shader IN LISTS BRAVAIS_SHADERS)
  vtk_encode_string(
    INPUT "Rendering/GLSL/${shader}.glsl"
    NAME "${shader}_glsl"
    EXPORT_SYMBOL "VTKBRAVAIS_EXPORT"
    EXPORT_HEADER "vtkBravaisModule.h"
    SOURCE_OUTPUT shader_source)
  list(APPEND shader_sources "${shader_source}")
endforeach ()

vtk_module_add_module(Bravais::Bravais
  CLASSES ${BRAVAIS_COMMON} ${BRAVAIS_FILTERS} ${BRAVAIS_RENDERING}
  PRIVATE_CLASSES ${BRAVAIS_COMMON_PRIVATE} ${BRAVAIS_FILTERS_PRIVATE} ${BRAVAIS_RENDERING_PRIVATE}
  NOWRAP_HEADERS ${core_headers} "Module/Common/vtkBravaisABINamespace.h"
  SOURCES ${shader_sources})
foreach (folder IN ITEMS Module/Core Module/Common Filters Rendering)
  vtk_module_include(Bravais::Bravais
    PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
endforeach ()
vtk_module_link(Bravais::Bravais
  PUBLIC glm::glm
  PRIVATE BravaisCore OpenImageIO::OpenImageIO roaring::roaring BravaisWarnings)
