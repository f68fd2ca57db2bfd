# Targets for any build folder: `make report` runs the cases and writes the report as ./run report does, into the
# source folder's results/ and report/; `make check` runs every test that needs no browser, but the hard cases.
add_custom_target(report
  COMMAND ${PROJECT_SOURCE_DIR}/cmake/write-report $<TARGET_FILE:modalbench>
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  DEPENDS modalbench
  USES_TERMINAL VERBATIM)

if(BUILD_TESTING)
  add_custom_target(check
    COMMAND ${CMAKE_CTEST_COMMAND} --output-on-failure -j2 -L "^(unit|layering|verification|cases)$"
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    USES_TERMINAL VERBATIM)
  add_dependencies(check unit_tests layering modalbench)

  # ./run on other systems, without root, without network: with stubs of all that it calls. Of no compiler's flags.
  if(NOT MODALBENCH_SANITIZE AND NOT MODALBENCH_LAUNCHER)
    add_test(NAME run-script COMMAND ${PROJECT_SOURCE_DIR}/cmake/run_test)
    add_test(NAME fuzz-script COMMAND ${PROJECT_SOURCE_DIR}/cmake/fuzz_test)
    set_tests_properties(run-script fuzz-script PROPERTIES LABELS unit TIMEOUT 300)
  endif()
endif()
