# Installs the build into a fresh prefix, builds a small program against it, runs it.
set(work "${BUILD}/install_test")
file(REMOVE_RECURSE "${work}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}"
                        --prefix "${work}/prefix"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/downstream" -B "${work}/build"
    -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
    "-DCMAKE_PREFIX_PATH=${work}/prefix")
run("${CMAKE_COMMAND}" --build "${work}/build")
execute_process(COMMAND "${work}/build/downstream" OUTPUT_VARIABLE output
                COMMAND_ERROR_IS_FATAL ANY)
message("${output}")
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "the program did not print the version ${EXPECTED}")
endif()

# The installed executable too, where there is one: it must find its own files.
if(EXISTS "${work}/prefix/bin/reeve")
  execute_process(COMMAND "${work}/prefix/bin/reeve" check OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()
