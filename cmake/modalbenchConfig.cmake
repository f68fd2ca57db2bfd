# find_package(modalbench): libraries modalbench::mechanics, cases, reference, modal, reports, harness.
if(NOT TARGET modalbench::harness)
  include(${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake)
  include(${CMAKE_CURRENT_LIST_DIR}/modalbenchTargets.cmake)
endif()
