# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Installs in two ways, by `cmake --install` into a prefix of its own and by the Debian package into
# a scratch root, then uses only what is there: one program through find_package(Bravais), one script
# through the Python package.

# The tests that use what was installed under a prefix, by the fixture that installs it.
function (_bravais_add_consumers name prefix fixture)
  add_test(NAME "Package.${name}Cxx"
    COMMAND "${CMAKE_CTEST_COMMAND}"
      --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/Package"
        "${CMAKE_CURRENT_BINARY_DIR}/Package/${fixture}Consumer"
      --build-generator "${CMAKE_GENERATOR}"
      --build-options "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
      --test-command Consumer)
  set_tests_properties("Package.${name}Cxx" PROPERTIES
    LABELS package FIXTURES_REQUIRED "${fixture}")
  if (BRAVAIS_WRAP_PYTHON)
    add_test(NAME "Package.${name}Python"
      COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Package/Consumer.py" "${prefix}")
    set_tests_properties("Package.${name}Python" PROPERTIES
      LABELS package FIXTURES_REQUIRED "${fixture}"
      ENVIRONMENT "PYTHONPATH=${prefix}/${BRAVAIS_PYTHON_DIR}")
  endif ()
endfunction ()

set(prefix "${CMAKE_CURRENT_BINARY_DIR}/Package/prefix")
add_test(NAME Package.Install
  COMMAND "${CMAKE_COMMAND}" --install "${PROJECT_BINARY_DIR}" --prefix "${prefix}")
set_tests_properties(Package.Install PROPERTIES LABELS package FIXTURES_SETUP installed)
_bravais_add_consumers("" "${prefix}" installed)

set(root "${CMAKE_CURRENT_BINARY_DIR}/Package/root")
add_test(NAME Package.DebianInstall
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/Package/install_debian.sh" "${PROJECT_BINARY_DIR}" "${root}")
set_tests_properties(Package.DebianInstall PROPERTIES
  LABELS package FIXTURES_SETUP debian DEPENDS Package.Install)
_bravais_add_consumers(Debian "${root}/usr" debian)
