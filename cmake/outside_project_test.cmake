# Installs the build into a scratch prefix and builds docs/outside-project against it: a case which names that
# project's method is valid for its program, and wrong for ours.
# cmake -DBUILD= -DSOURCE= -DSCRATCH= -DCXX= -DLINK=<linker flags> -P outside_project_test.cmake
cmake_minimum_required(VERSION 3.25)

# expect(CODE command...)
function(expect code)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result STREQUAL code)
    message(FATAL_ERROR "expected exit code ${code}, got ${result}: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
expect(0 ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
expect(0 ${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH}/build -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
  -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXE_LINKER_FLAGS=${LINK})
expect(0 ${CMAKE_COMMAND} --build ${SCRATCH}/build)

file(READ ${SCRATCH}/prefix/share/modalbench/cases/cylinder-compression.toml case)
string(REPLACE "\"static-correction\"" "\"at-rest\"" case "${case}")
file(WRITE ${SCRATCH}/at-rest.toml "${case}")
expect(0 ${SCRATCH}/build/outside check ${SCRATCH}/at-rest.toml)
expect(2 ${SCRATCH}/prefix/bin/modalbench check ${SCRATCH}/at-rest.toml)
