# cmake --install: the program, its cases, and the package `modalbench`, with which an outside project adds methods:
#
#   find_package(modalbench) then target_link_libraries(mine PRIVATE modalbench::harness)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/modalbench)
set(layers mechanics cases reference modal reports harness)

list(TRANSFORM layers PREPEND mb_ OUTPUT_VARIABLE libraries)
set_target_properties(mb_options PROPERTIES EXPORT_NAME options)
install(TARGETS mb_options ${libraries} EXPORT modalbench ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS modalbench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(layer IN LISTS layers)
  # Headers below reference/fem/ show deal.II and stay inside.
  file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${layer}/*.h)
  list(FILTER headers EXCLUDE REGEX "^reference/fem/|/node_modules/|_(test|fuzz)\\.h$")
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/modalbench/${folder})
  endforeach()
endforeach()
file(GLOB cases CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.toml)
install(FILES ${cases} DESTINATION ${CMAKE_INSTALL_DATADIR}/modalbench/cases)
file(GLOB hard_cases CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/hard/*.toml)
install(FILES ${hard_cases} DESTINATION ${CMAKE_INSTALL_DATADIR}/modalbench/cases/hard)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT modalbench FILE modalbenchTargets.cmake NAMESPACE modalbench:: DESTINATION ${package_dir})
write_basic_package_version_file(modalbenchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/modalbenchConfig.cmake ${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake
              ${PROJECT_BINARY_DIR}/modalbenchConfigVersion.cmake
        DESTINATION ${package_dir})

if(BUILD_TESTING AND NOT MODALBENCH_SANITIZE)   # an outside project would need the same sanitizer flags
  add_test(NAME outside_project
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR}/docs/outside-project
            -DSCRATCH=${PROJECT_BINARY_DIR}/outside_project -DCXX=${CMAKE_CXX_COMPILER}
            "-DLINK=$<$<BOOL:${MODALBENCH_LLD}>:-fuse-ld=lld>"
            -P ${CMAKE_CURRENT_LIST_DIR}/outside_project_test.cmake)
  set_tests_properties(outside_project PROPERTIES LABELS cases TIMEOUT 300)
endif()
