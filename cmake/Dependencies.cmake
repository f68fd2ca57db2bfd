# Third-party libraries, each as one target with SYSTEM includes. Versions: those of Debian 12, the oldest tested.
# Installed beside the package file too, which includes it again: a static library's users link what it links.
# What ships no package file becomes an imported target, which an export names and does not copy.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(Threads REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(LAPACK REQUIRED)   # any, 3.2 or newer; OpenBLAS has one

find_package(PkgConfig REQUIRED)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET GLOBAL tomlplusplus)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET GLOBAL muparser)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET GLOBAL libxxhash)
pkg_check_modules(zlib REQUIRED IMPORTED_TARGET GLOBAL zlib)

# mb_find_library(NAME HEADER LIBRARIES... [SUFFIXES ...] [PATHS ...]): target mb_NAME of a library without package
# file. PATHS: where alone its header may be.
function(mb_find_library name header)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SUFFIXES;PATHS" ${ARGN})
  if(ARG_PATHS)
    find_path(MODALBENCH_${name}_INCLUDE ${header} PATHS ${ARG_PATHS} NO_DEFAULT_PATH REQUIRED)
  else()
    find_path(MODALBENCH_${name}_INCLUDE ${header} PATH_SUFFIXES ${ARG_SUFFIXES} REQUIRED)
  endif()
  add_library(mb_${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(mb_${name} SYSTEM INTERFACE ${MODALBENCH_${name}_INCLUDE})
  foreach(library IN LISTS ARG_LIBRARIES)
    find_library(MODALBENCH_${name}_${library} ${library} REQUIRED)
    target_link_libraries(mb_${name} INTERFACE ${MODALBENCH_${name}_${library}})
  endforeach()
endfunction()
mb_find_library(cholmod cholmod.h LIBRARIES cholmod openblas SUFFIXES suitesparse)
# METIS 5.1 takes signals for itself (harness/metis_signals.h); that of SuiteSparse 7 does not.
include(CheckLibraryExists)
check_library_exists(metis gk_sigtrap "" MODALBENCH_METIS_TAKES_SIGNALS)
add_library(mb_metis INTERFACE IMPORTED GLOBAL)
if(MODALBENCH_METIS_TAKES_SIGNALS)
  target_link_libraries(mb_metis INTERFACE metis)
else()
  message(STATUS "No METIS that takes signals by -lmetis: SIGTERM is taken to be left alone")
endif()
mb_find_library(umfpack umfpack.h LIBRARIES umfpack SUFFIXES suitesparse)
mb_find_library(arpack arpack/arpack.hpp LIBRARIES arpack)
# Headers alone: its package file would bring flags of its own, and GMP, which boxes do without.
mb_find_library(cgal CGAL/AABB_tree.h)
mb_find_library(sundials arkode/arkode_arkstep.h LIBRARIES sundials_arkode sundials_nvecserial)
# The serial HDF5: deal.II brings the MPI one, whose headers the door of ours must never see.
mb_find_library(hdf5 hdf5.h LIBRARIES hdf5_serial PATHS /usr/include/hdf5/serial)

# deal.II: the target of its installation, not deal_ii_setup_target, which puts its own flags behind ours.
find_package(deal.II 9.4 REQUIRED)
include(${DEAL_II_TARGET_CONFIG})
add_library(mb_dealii INTERFACE IMPORTED GLOBAL)
# Its MPI HDF5 must not be on our link line, or the door would bind to it; libdeal.ii.so itself still finds it.
get_target_property(dealii_libraries ${DEAL_II_TARGET_RELEASE} INTERFACE_LINK_LIBRARIES)
list(FILTER dealii_libraries EXCLUDE REGEX "hdf5")
target_link_libraries(mb_dealii INTERFACE $<TARGET_FILE:${DEAL_II_TARGET_RELEASE}> ${dealii_libraries})
set(dealii_includes ${DEAL_II_INCLUDE_DIRS})   # its target carries none
list(REMOVE_ITEM dealii_includes /usr/include)
target_include_directories(mb_dealii SYSTEM INTERFACE ${dealii_includes})
