# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# The project's half: the library, its Python package and the CMake package.

# Core: the maths as object files, without VTK. The library takes them in, and so do the Core tests.
include(Module/Core/Core.cmake)
list(TRANSFORM BRAVAIS_CORE PREPEND "Module/Core/")
add_library(BravaisCore OBJECT)
foreach (source IN LISTS BRAVAIS_CORE)
  target_sources(BravaisCore PRIVATE "${source}.h" "${source}.cxx")
endforeach ()
target_include_directories(BravaisCore
  PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/Module/Core"
  PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
target_include_directories(BravaisCore SYSTEM PRIVATE "${KISSFFT_INCLUDE_DIR}")
target_link_libraries(BravaisCore PUBLIC glm::glm
  PRIVATE hwy::hwy Eigen3::Eigen roaring::roaring BravaisWarnings)

# vtk_module_build() adds each module's source folder as a build folder of the same relative path.
# For a module at the root that is the build folder itself, so it is moved aside for this one call.
set(bravais_binary_dir "${CMAKE_BINARY_DIR}")
set(CMAKE_BINARY_DIR "${bravais_binary_dir}/module")
vtk_module_build(
  MODULES ${bravais_modules}
  PACKAGE Bravais
  INSTALL_EXPORT BravaisTargets
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/bravais"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Bravais"
  TEST_DIRECTORY_NAME NONE)
set(CMAKE_BINARY_DIR "${bravais_binary_dir}")

if (BRAVAIS_WRAP_PYTHON)
  vtk_module_wrap_python(
    MODULES ${bravais_modules}
    TARGET Bravais::Python
    PYTHON_PACKAGE bravais
    MODULE_DESTINATION "${BRAVAIS_PYTHON_DIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Bravais"
    BUILD_STATIC OFF)
  set(package "${CMAKE_BINARY_DIR}/${BRAVAIS_PYTHON_DIR}/bravais")
  foreach (file IN ITEMS __init__ arrays pictures pipeline)
    configure_file("Module/Python/${file}.py" "${package}/${file}.py" @ONLY)
    install(FILES "${package}/${file}.py" DESTINATION "${BRAVAIS_PYTHON_DIR}/bravais")
  endforeach ()
endif ()

include(CMakePackageConfigHelpers)
configure_package_config_file(Module/CMake/BravaisConfig.cmake.in
  "${CMAKE_CURRENT_BINARY_DIR}/BravaisConfig.cmake"
  INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Bravais")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/BravaisConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/BravaisConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/BravaisConfigVersion.cmake"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Bravais")
