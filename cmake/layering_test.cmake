# The layering check must be able to fail: a small tree with one violation of each kind, every one to be named.
# cmake -DLAYERING=<program> -DTREE=<scratch folder> -P layering_test.cmake
cmake_minimum_required(VERSION 3.25)

function(source path)   # source(path lines...)
  list(JOIN ARGN "\n" text)
  file(WRITE ${TREE}/${path} "${text}\n")
endfunction()

# expect(CODE lines...): exit code and the whole output of the check
function(expect code)
  list(JOIN ARGN "\n" wanted)
  execute_process(COMMAND ${LAYERING} ${TREE} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT result STREQUAL code OR NOT output STREQUAL "${wanted}\n")
    message(FATAL_ERROR "expected exit code ${code} and\n${wanted}\n--- got ${result} and\n${output}${error}")
  endif()
endfunction()

file(REMOVE_RECURSE ${TREE})
source(mechanics/types.h "#include <Eigen/Dense>" "#include <vector>" "#include <dlfcn.h>")
source(mechanics/algebra/cholesky.cc "#include <Eigen/CholmodSupport>" "#  include <cholmod.h>")
source(cases/scene.h "#include <fmt/format.h>" "#include \"mechanics/types.h\"")
source(reference/fem/mesh.cc "#include <deal.II/grid/tria.h>" "#include \"cases/scene.h\"")
source(reference/mesh.h "#pragma once")
source(modal/basis_test.cc "#include <gtest/gtest.h>" "#include \"reference/mesh.h\"" "#include \"../mechanics/types.h\"")
source(reports/page.cc "// steady_clock is only named here")
source(reports/web/node_modules/x/x.cc "#include <windows.h>")
source(harness/measure.cc "#include <chrono>" "#include \"sources.h\"" "#include \"version.h\"" "auto t = std::chrono::steady_clock::now();")
expect(0 "8 files, 0 violations")

string(REPEAT "\n" 301 long)
file(WRITE ${TREE}/harness/long.cc "${long}")
source(mechanics/up.h "" "#include \"cases/scene.h\"")
source(cases/up.h "#include \"../harness/main.h\"" "#include <modal/basis.h>")
source(harness/main.h "#include \"reports/page.h\"")
source(modal/hash.cc "#include \"sources.h\"")
source(reference/sideways_test.cc "#include \"modal/basis.h\"")
source(modal/sideways.cc "#include \"reference/mesh.h\"" "  # include <deal.II/grid/tria.h>")
source(modal/basis.h "#pragma once")
source(reports/third.cc "#include <Eigen/CholmodSupport>" "#include \"hdf5.h\"" "#include <boost/any.hpp>" "#include \"missing.h\"")
source(modal/time.cc "#include <chrono>" "int f() { return clock_gettime(0, nullptr); }")
expect(1
  "cases/up.h:1: cases must not include harness: \"harness/main.h\""
  "cases/up.h:2: cases must not include modal: \"modal/basis.h\""
  "harness/long.cc:301: longer than 300 lines"
  "mechanics/up.h:2: mechanics must not include cases: \"cases/scene.h\""
  "modal/hash.cc:1: modal must not include harness: \"harness/sources.h\""
  "modal/sideways.cc:1: modal must not include reference: \"reference/mesh.h\""
  "modal/sideways.cc:2: <deal.II/grid/tria.h> outside the door of deal.II, reference/fem/"
  "modal/time.cc:1: <chrono> outside the door of clock, harness/measure.cc"
  "modal/time.cc:2: clock_gettime outside the door of clock, harness/measure.cc"
  "reference/sideways_test.cc:1: reference must not include modal: \"modal/basis.h\""
  "reports/third.cc:1: <Eigen/CholmodSupport> outside the door of SuiteSparse, mechanics/algebra/"
  "reports/third.cc:2: <hdf5.h> outside the door of HDF5, harness/store/hdf5.cc"
  "reports/third.cc:3: <boost/any.hpp> is of no known library: give it a door"
  "reports/third.cc:4: <missing.h> is of no known library: give it a door"
  "18 files, 14 violations")

file(REMOVE_RECURSE ${TREE}/reports)
execute_process(COMMAND ${LAYERING} ${TREE} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
if(NOT result EQUAL 2 OR NOT error MATCHES "no folder reports")
  message(FATAL_ERROR "a missing folder must be an error, got ${result}: ${error}")
endif()
