# Tests `layering`: the includes of the project obey its layers and doors, and the check of them can fail.
if(NOT BUILD_TESTING)
  return()
endif()
add_executable(layering ${CMAKE_CURRENT_LIST_DIR}/layering.cc)
target_link_libraries(layering PRIVATE mb_warnings)
target_compile_features(layering PRIVATE cxx_std_20)
add_test(NAME layering COMMAND layering ${PROJECT_SOURCE_DIR})
add_test(NAME layering_names_violations
  COMMAND ${CMAKE_COMMAND} -DLAYERING=$<TARGET_FILE:layering> -DTREE=${PROJECT_BINARY_DIR}/layering_tree
          -P ${CMAKE_CURRENT_LIST_DIR}/layering_test.cmake)
set_tests_properties(layering layering_names_violations PROPERTIES LABELS layering TIMEOUT 60)
