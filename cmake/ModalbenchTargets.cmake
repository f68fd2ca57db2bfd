# mb_library(NAME LINK... [PRIVATE_LINK ...] [HEADERS to precompile])  library mb_NAME of every source of the current
#   folder that is no test.
# mb_tests(NAME [LINK ...] [HEADERS to precompile] [SHARED ...] [LONG regex])  one GoogleTest binary of every *_test.cc
#   of the current folder; suites of label `cases` whose tests share what the first of them computes, SHARED, run as
#   one test each; tests whose names match LONG take a minute and more: they are `long`, too.
# mb_fuzz(NAME SOURCE... LINK ...)  one libFuzzer binary; the first source, X_fuzz.cc, names its seeds, X_fuzz/

set(MODALBENCH_SANITIZE "" CACHE STRING "Sanitizers to compile with: address, undefined (comma-separated)")
set(MODALBENCH_LAUNCHER "" CACHE STRING
  "What unit tests are run by: valgrind with its options (see the preset `valgrind`)")
set(MODALBENCH_AT_ONCE 8 CACHE STRING "Sources that are compiled as one, 1: each by itself (see JoinSources.cmake)")
if(NOT MODALBENCH_AT_ONCE MATCHES "^[1-9][0-9]*$")
  message(FATAL_ERROR "MODALBENCH_AT_ONCE is '${MODALBENCH_AT_ONCE}': it must be a whole number from 1")
endif()
include(JoinSources)
option(MODALBENCH_FUZZ "Instrument for libFuzzer and define its targets (clang++; see the preset `fuzz`)" OFF)
option(MODALBENCH_NATIVE "Compile for this machine's processor (-march=native)" OFF)

add_library(mb_options INTERFACE)
target_include_directories(mb_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/modalbench>)
target_compile_features(mb_options INTERFACE cxx_std_20)
if(MODALBENCH_NATIVE)   # public: Eigen's alignment, hence the layout of its types, follows from the instruction set
  target_compile_options(mb_options INTERFACE -march=native)
endif()

# Warnings are for our own code: never exported, third-party headers are SYSTEM. What is turned off are false alarms of
# g++ 12 in its own headers (AVX-512 intrinsics, std::string). Sanitizers provoke more of them: no errors there.
add_library(mb_warnings INTERFACE)
target_compile_options(mb_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow -Wno-sign-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized;-Wno-restrict;-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-use-after-free>)
if(NOT MODALBENCH_SANITIZE)
  target_compile_options(mb_warnings INTERFACE -Werror)
endif()
if(MODALBENCH_FUZZ)
  add_custom_target(fuzz_targets)
endif()
if(MODALBENCH_SANITIZE)
  # pointer-overflow: parts of empty matrices, which Eigen 3.4 makes by an offset to null (Block.h) and never reads.
  # Some of the others the address sanitizer and Eigen's assertions report as well; together they would take a third of
  # the time to compile. The preset `ubsan` has these.
  set(unasked pointer-overflow)
  if(MODALBENCH_SANITIZE MATCHES address)
    string(PREPEND unasked "null,alignment,vptr,object-size,")
  endif()
  target_compile_options(mb_warnings INTERFACE -fsanitize=${MODALBENCH_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize=${unasked} -fno-sanitize-recover=all)
  target_compile_definitions(mb_warnings INTERFACE MB_SANITIZED)
  add_link_options(-fsanitize=${MODALBENCH_SANITIZE})
endif()

find_program(MODALBENCH_LLD ld.lld)
if(MODALBENCH_LLD)      # GNU ld takes 10 s an executable with deal.II's libraries, lld 0.4 s
  add_link_options(-fuse-ld=lld)
  # g++ 12 leaves empty cold parts of destructors, whose unwind entries of length 0 hide their neighbours' from lld's
  # table: an exception thrown there would end the program.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-reorder-blocks-and-partition>)
endif()
find_program(MODALBENCH_CCACHE ccache)
if(MODALBENCH_CCACHE)   # the sloppiness is what it needs to cache with precompiled headers
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros ${MODALBENCH_CCACHE})
endif()

# g++ stops at every 128 MiB to look for memory it may reuse, which takes a tenth of the time: here after 1 GB.
add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:SHELL:--param ggc-min-heapsize=1000000>")

# Headers that nearly every source includes, parsed once a folder: half of the time to compile.
set(MODALBENCH_COMMON_HEADERS <Eigen/Dense> <Eigen/Sparse> <fmt/format.h> <algorithm> <cmath> <complex> <filesystem>
  <functional> <map> <memory> <optional> <random> <ranges> <stdexcept> <string> <variant> <vector>)
set(MODALBENCH_SCENE_HEADERS <cases/contract/model.h> <cases/scene/scene.h>)   # of folders above cases

function(mb_library name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE_LINK;HEADERS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  list(FILTER sources EXCLUDE REGEX "_(test|bench|main|fuzz)\\.cc$")
  mb_join_sources(joined ${sources})
  add_library(mb_${name} STATIC ${joined})
  set_target_properties(mb_${name} PROPERTIES EXPORT_NAME ${name})
  target_precompile_headers(mb_${name} PRIVATE ${MODALBENCH_COMMON_HEADERS} ${ARG_HEADERS})
  # A folder's own libraries come first on the link line: deal.II brings another build of HDF5 with the same symbols.
  foreach(library IN LISTS ARG_PRIVATE_LINK)
    target_link_libraries(mb_${name} PRIVATE ${library})
  endforeach()
  target_link_libraries(mb_${name} PUBLIC mb_options ${ARG_LINK})
  target_link_libraries(mb_${name} PRIVATE $<BUILD_INTERFACE:mb_warnings>)
  # g++ takes joined sources for headers, whose unnamed namespaces would be one a file.
  target_compile_options(mb_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

set(MODALBENCH_PATIENCE 1)   # times the limits of tests [s]
if(MODALBENCH_SANITIZE)
  set(MODALBENCH_PATIENCE 10)
elseif(MODALBENCH_LAUNCHER)
  set(MODALBENCH_PATIENCE 40)
endif()

if(BUILD_TESTING)
  find_package(GTest 1.12 REQUIRED)
  include(GoogleTest)
  add_custom_target(unit_tests)   # every test binary
endif()

# mb_join_tests(JOINED SOURCE...): sources of MODALBENCH_AT_ONCE tests' each, made in the build folder, and those
# that have no test but what tests share, as they are.
function(mb_join_tests joined)
  set(tests "")
  set(files "")
  foreach(source IN LISTS ARGN)
    file(STRINGS ${source} found REGEX "^(TEST|TYPED_TEST)" LIMIT_COUNT 1)
    if(found AND MODALBENCH_AT_ONCE GREATER 1)
      list(APPEND tests ${source})
    else()
      list(APPEND files ${source})
    endif()
  endforeach()
  set(first 0)
  list(LENGTH tests n)
  while(first LESS n)
    list(SUBLIST tests ${first} ${MODALBENCH_AT_ONCE} some)
    list(JOIN some "," words)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/tests_from_${first}.cc)
    add_custom_command(OUTPUT ${file} VERBATIM DEPENDS ${some} ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake
      COMMAND ${CMAKE_COMMAND} -DOUT=${file} -DFIRST=${first} -DSOURCES=${words}
        -P ${PROJECT_SOURCE_DIR}/cmake/join_tests.cmake)
    list(APPEND files ${file})
    math(EXPR first "${first} + ${MODALBENCH_AT_ONCE}")
  endwhile()
  set(${joined} ${files} PARENT_SCOPE)
endfunction()

# Tests are found by gtest_discover_tests; a test suite whose name ends in "Verification" carries the label
# `verification` (an independent target), "Cases" the label `cases` (runs the program), all others `unit`.
# deal.II's libraries take half a second to load, seconds under sanitizers and by valgrind: unit tests run in a few
# processes of hundreds each. One alone: build/native/modal/modal_test --gtest_filter=NAME.
function(mb_tests name)
  if(NOT BUILD_TESTING)
    return()
  endif()
  cmake_parse_arguments(ARG "" "LONG" "LINK;HEADERS;SHARED" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cc)
  if(NOT sources)
    return()
  endif()
  mb_join_tests(joined ${sources})
  add_executable(${name}_test ${joined})
  target_link_libraries(${name}_test PRIVATE mb_${name} mb_warnings ${ARG_LINK} GTest::gmock GTest::gtest_main)
  add_dependencies(unit_tests ${name}_test)
  target_precompile_headers(${name}_test PRIVATE ${MODALBENCH_COMMON_HEADERS} ${ARG_HEADERS} <gmock/gmock.h>
    <gtest/gtest.h>)
  # What is tested is optimised; optimising the tests as well would double the time to build them.
  target_compile_options(${name}_test PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(${name}_test PRIVATE MB_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  set(common NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60)
  # MarksVerification computes truths on finer meshes: minutes alone, several times that on a loaded machine.
  math(EXPR verification_limit "900 * ${MODALBENCH_PATIENCE}")
  math(EXPR cases_limit "600 * ${MODALBENCH_PATIENCE}")
  gtest_discover_tests(${name}_test TEST_FILTER *Verification.* TEST_LIST ${name}_verification ${common}
    PROPERTIES LABELS verification TIMEOUT ${verification_limit})
  list(TRANSFORM ARG_SHARED APPEND ".*")
  list(JOIN ARG_SHARED ":" shared)
  gtest_discover_tests(${name}_test TEST_FILTER *Cases.*:-${shared} TEST_LIST ${name}_cases ${common}
    PROPERTIES LABELS cases TIMEOUT ${cases_limit})
  foreach(suite IN LISTS ARG_SHARED)
    string(REPLACE ".*" "" suite_name ${suite})
    add_test(NAME ${suite_name} COMMAND ${name}_test --gtest_brief=1 --gtest_filter=${suite})
    set_tests_properties(${suite_name} PROPERTIES LABELS cases TIMEOUT ${cases_limit})
  endforeach()
  foreach(kind verification cases)   # read by ctest: gtest_discover_tests takes one label
    file(CONFIGURE OUTPUT ${name}_${kind}_long.cmake @ONLY CONTENT [[
foreach(test IN LISTS @name@_@kind@)
  if(test MATCHES "^(@ARG_LONG@)$")
    set_tests_properties(${test} PROPERTIES LABELS "@kind@;long")
  endif()
endforeach()
]])
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}_${kind}_long.cmake)
  endforeach()
  set(unit -*Verification.*:*Cases.*)
  set(n_shards 4)
  if(MODALBENCH_LAUNCHER)
    set(n_shards 16)
  endif()
  math(EXPR last_shard "${n_shards} - 1")
  math(EXPR shard_limit "180 * ${MODALBENCH_PATIENCE}")
  foreach(shard RANGE ${last_shard})
    add_test(NAME ${name}.unit.${shard}
      COMMAND ${MODALBENCH_LAUNCHER} $<TARGET_FILE:${name}_test> --gtest_brief=1 --gtest_filter=${unit})
    set_tests_properties(${name}.unit.${shard} PROPERTIES LABELS unit TIMEOUT ${shard_limit}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${n_shards};GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()

function(mb_fuzz name source)
  if(NOT MODALBENCH_FUZZ)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${name}_fuzz ${source} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name}_fuzz PRIVATE mb_warnings ${ARG_LINK})
  # libFuzzer follows the branches and comparisons of what readers run through.
  foreach(library ${name}_fuzz ${ARG_LINK})
    if(library MATCHES "^mb_(mechanics|cases|store)$|_fuzz$")
      target_compile_options(${library} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
  endforeach()
  target_compile_definitions(${name}_fuzz PRIVATE MB_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_options(${name}_fuzz PRIVATE -fsanitize=fuzzer)
  set_target_properties(${name}_fuzz PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzz)
  add_dependencies(fuzz_targets ${name}_fuzz)
endfunction()
