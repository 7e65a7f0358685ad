# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Installs the build tree into a folder of its own, then uses only what is there: one program
# through find_package(Bravais), one script through the Python package.

set(prefix "${CMAKE_CURRENT_BINARY_DIR}/Package/prefix")
add_test(NAME Package.Install
  COMMAND "${CMAKE_COMMAND}" --install "${PROJECT_BINARY_DIR}" --prefix "${prefix}")
set_tests_properties(Package.Install PROPERTIES LABELS package FIXTURES_SETUP installed)

add_test(NAME Package.Cxx
  COMMAND "${CMAKE_CTEST_COMMAND}"
    --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/Package"
      "${CMAKE_CURRENT_BINARY_DIR}/Package/consumer"
    --build-generator "${CMAKE_GENERATOR}"
    --build-options "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
    --test-command Consumer)
set_tests_properties(Package.Cxx PROPERTIES LABELS package FIXTURES_REQUIRED installed)

if (BRAVAIS_WRAP_PYTHON)
  add_test(NAME Package.Python
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Package/Consumer.py" "${prefix}")
  set_tests_properties(Package.Python PROPERTIES LABELS package FIXTURES_REQUIRED installed
    ENVIRONMENT "PYTHONPATH=${prefix}/${BRAVAIS_PYTHON_DIR}")
endif ()
