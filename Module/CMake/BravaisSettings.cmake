# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Where things go, and how they are compiled.

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif ()

# The same layout on every system: lib, never lib64 or lib/<architecture>.
set(CMAKE_INSTALL_LIBDIR lib CACHE STRING "Libraries, relative to the prefix")
include(GNUInstallDirs)
set(BRAVAIS_PYTHON_DIR "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")

set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")

set(BUILD_SHARED_LIBS ON) # The Python package and its users must share one copy of the classes.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if (BRAVAIS_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif ()

# Every target of the project's own code links this one: it carries the warnings. Generated code
# (the Python wrapping) does not.
add_library(BravaisWarnings INTERFACE)
if (BRAVAIS_STRICT)
  target_compile_options(BravaisWarnings INTERFACE -Wall -Wextra -Wshadow -Wcast-qual
    -Wnon-virtual-dtor -Woverloaded-virtual -Wundef -Wvla -Werror)
endif ()
