# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Two functions that declare tests of the classes.
#
#   bravais_add_cxx_tests(<executable> FILTERS <name>... RENDERING <name>...)
#     Each TestX.cxx defines `int TestX(int argc, char* argv[])`, returning EXIT_SUCCESS or
#     EXIT_FAILURE; all of them become one executable. ctest name Cxx.TestX.
#   bravais_add_python_tests(FILTERS <name>... RENDERING <name>...)
#     Each TestX.py is run by itself with the build tree's package. ctest name Python.TestX.
#
# FILTERS tests need no display. RENDERING tests do; C++ ones are given -V and the path of
# Data/Baseline/TestX.png and -T and a folder for pictures, as vtkRegressionTestImage() expects,
# and Python ones the same two in the environment as BRAVAIS_BASELINE and BRAVAIS_TEMPORARY.
# An error that VTK reports fails any test, so a test of bad input observes it (vtkTest::
# ErrorObserver in C++, an ErrorEvent observer in Python). No result counts as skipped.

set(BRAVAIS_BASELINES "${CMAKE_CURRENT_SOURCE_DIR}/Data/Baseline")
set(BRAVAIS_TEMPORARY "${CMAKE_CURRENT_BINARY_DIR}/Temporary")
file(MAKE_DIRECTORY "${BRAVAIS_TEMPORARY}")

# Where Mesa draws by llvmpipe, most of the time of small pictures goes into optimising shaders.
set(BRAVAIS_TEST_ENVIRONMENT "GALLIVM_PERF=nopt")
if (BRAVAIS_SANITIZE)
  # Leaks are looked for in Core only: Python and the OpenGL driver keep memory until the end.
  list(APPEND BRAVAIS_TEST_ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
endif ()

function (_bravais_test_properties name label)
  set_tests_properties("${name}" PROPERTIES
    LABELS "${label}"
    TIMEOUT 300
    ENVIRONMENT "${BRAVAIS_TEST_ENVIRONMENT};${ARGN}"
    FAIL_REGULAR_EXPRESSION "(^|\n)ERROR: ;ERR\\|;instance(s)? still around;Failed Image Test")
endfunction ()

function (bravais_add_cxx_tests executable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILTERS;RENDERING")
  set(DISABLE_FLOATING_POINT_EXCEPTIONS ON) # OpenGL drivers raise them.
  set(_vtk_build_TEST_OUTPUT_DIRECTORY "${BRAVAIS_TEMPORARY}")
  include("${VTK_DIR}/vtkTestingRenderingDriver.cmake")
  list(TRANSFORM arg_FILTERS APPEND ".cxx" OUTPUT_VARIABLE filter_sources)
  list(TRANSFORM arg_RENDERING APPEND ".cxx" OUTPUT_VARIABLE rendering_sources)
  create_test_sourcelist(sources "${executable}.cxx" ${filter_sources} ${rendering_sources}
    EXTRA_INCLUDE vtkTestingObjectFactory.h)
  add_executable("${executable}" ${sources})
  get_property(depends GLOBAL PROPERTY "_vtk_module_Bravais::Bravais_test_depends")
  target_link_libraries("${executable}" PRIVATE Bravais::Bravais BravaisWarnings ${depends})
  vtk_module_autoinit(TARGETS "${executable}" MODULES Bravais::Bravais
    VTK::RenderingOpenGL2 VTK::RenderingVolumeOpenGL2 ${depends})
  foreach (test IN LISTS arg_FILTERS)
    add_test(NAME "Cxx.${test}" COMMAND "${executable}" "${test}" -T "${BRAVAIS_TEMPORARY}")
    _bravais_test_properties("Cxx.${test}" filters)
  endforeach ()
  foreach (test IN LISTS arg_RENDERING)
    add_test(NAME "Cxx.${test}" COMMAND "${executable}" "${test}"
      -T "${BRAVAIS_TEMPORARY}" -V "${BRAVAIS_BASELINES}/${test}.png")
    _bravais_test_properties("Cxx.${test}" rendering)
  endforeach ()
endfunction ()

function (bravais_add_python_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILTERS;RENDERING")
  set(environment "PYTHONPATH=${PROJECT_BINARY_DIR}/${BRAVAIS_PYTHON_DIR}")
  if (BRAVAIS_SANITIZE)
    # The interpreter itself is not instrumented. Exceptions are watched only if their library is
    # there from the beginning, too.
    foreach (library IN ITEMS asan stdc++)
      execute_process(COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=lib${library}.so"
        OUTPUT_VARIABLE ${library} OUTPUT_STRIP_TRAILING_WHITESPACE)
    endforeach ()
    list(APPEND environment "LD_PRELOAD=${asan}:${stdc++}")
  endif ()
  foreach (test IN LISTS arg_FILTERS arg_RENDERING)
    add_test(NAME "Python.${test}"
      COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${test}.py")
    set(label filters)
    if (test IN_LIST arg_RENDERING)
      set(label rendering)
    endif ()
    _bravais_test_properties("Python.${test}" "${label}" ${environment}
      "BRAVAIS_BASELINE=${BRAVAIS_BASELINES}/${test}.png"
      "BRAVAIS_TEMPORARY=${BRAVAIS_TEMPORARY}")
  endforeach ()
endfunction ()
