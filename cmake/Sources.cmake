# Writes generated/sources.h at every build: hashes of the sources that results depend on, versions of the libraries,
# the commit. The file is touched only when something changed. Run as a script by the target mb_sources.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  file(STRINGS ${MODALBENCH_sundials_INCLUDE}/sundials/sundials_config.h sundials_version
    REGEX "define SUNDIALS_VERSION ")
  string(REGEX MATCH "[0-9.]+" sundials_version "${sundials_version}")
  set(libraries "deal.II ${DEAL_II_PACKAGE_VERSION}, SUNDIALS ${sundials_version}, Eigen ${Eigen3_VERSION}")
  string(APPEND libraries ", muParser ${muparser_VERSION}, ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  string(APPEND libraries " ${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS}")
  if(MODALBENCH_NATIVE)
    string(APPEND libraries " native")
  endif()
  add_custom_target(mb_sources BYPRODUCTS ${PROJECT_BINARY_DIR}/generated/sources.h
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DOUT=${PROJECT_BINARY_DIR}/generated/sources.h
            "-DLIBRARIES=${libraries}" -P ${CMAKE_CURRENT_LIST_FILE} VERBATIM)
  return()
endif()

function(hash_of variable)
  set(text "")
  foreach(place IN LISTS ARGN)   # a folder or a file
    file(GLOB_RECURSE files ${ROOT}/${place}/*.h ${ROOT}/${place}/*.cc ${ROOT}/${place})
    # Which decide no result:
    list(FILTER files EXCLUDE REGEX "_(test|bench|fuzz)\\.(h|cc)$|/(estimate|definitions|case_files)\\.(h|cc)$")
    if(NOT files)
      message(FATAL_ERROR "no source at ${place}")
    endif()
    list(SORT files)
    foreach(file IN LISTS files)
      file(SHA256 ${file} hash)
      file(RELATIVE_PATH name ${ROOT} ${file})
      string(APPEND text "${name} ${hash}\n")
    endforeach()
  endforeach()
  string(SHA256 hash "${text}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()
hash_of(reference mechanics cases/contract cases/scene cases/exact reference harness/study/truth.cc harness/store
        harness/catalogue.cc)
hash_of(contenders modal harness/metrics harness/study harness/measure.cc harness/measure.h)
hash_of(analyses harness/analysis)

execute_process(COMMAND git -C ${ROOT} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "unknown")
endif()
set(text "// Generated: what results depend on besides the scene.
#pragma once

namespace mb::sources {

inline constexpr char reference[] = \"${reference}\";
inline constexpr char contenders[] = \"${contenders}\";
inline constexpr char analyses[] = \"${analyses}\";
inline constexpr char libraries[] = \"${LIBRARIES}\";
inline constexpr char commit[] = \"${commit}\";

}  // namespace mb::sources
")
set(old "")
if(EXISTS ${OUT})
  file(READ ${OUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUT} "${text}")
endif()
