# A machine without the npm registry: configuring fails at once and says what to do, and with
# REEVE_PAGES=OFF it does not ask for npm.
set(work "${BUILD}/no_registry_test")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")

# Port 9 of this machine answers nobody, and the cache is empty.
function(configure result_variable said_variable)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env npm_config_registry=http://127.0.0.1:9/
            "npm_config_cache=${work}/cache" "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${work}/build"
            -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}" -DREEVE_TESTS=OFF ${ARGN}
    TIMEOUT 120
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  set(${result_variable} "${result}" PARENT_SCOPE)
  set(${said_variable} "${said}" PARENT_SCOPE)
endfunction()

configure(result said)
if(result EQUAL 0)
  message(FATAL_ERROR "configured without the packages of npm")
endif()
foreach(sentence IN ITEMS "npm could not fetch the packages of pages" "npm config get registry"
                          "REEVE_PAGES=OFF")
  string(FIND "${said}" "${sentence}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "expected \"${sentence}\" in:\n${said}")
  endif()
endforeach()

configure(result said -DREEVE_PAGES=OFF)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "REEVE_PAGES=OFF does not configure:\n${said}")
endif()
