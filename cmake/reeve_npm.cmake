# reeve_npm_packages(<name> <folder> <variable>): installs exactly the packages that
# <folder>/package-lock.json names into ${PROJECT_BINARY_DIR}/npm/<name>/node_modules. It does so when
# CMake configures, so that a registry that cannot be reached is reported before anything is compiled.
# The variable gets a file to depend on.
function(reeve_npm_packages name folder variable)
  set(place "${PROJECT_BINARY_DIR}/npm/${name}")
  set(stamp "${place}/installed")
  set(${variable} "${stamp}" PARENT_SCOPE)
  set(wanted "")
  foreach(file IN ITEMS package.json package-lock.json .npmrc)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/${file}")
    file(COPY "${folder}/${file}" DESTINATION "${place}")
    file(SHA256 "${folder}/${file}" hash)
    string(APPEND wanted "${hash}\n")
  endforeach()
  if(EXISTS "${stamp}")
    file(READ "${stamp}" installed)
    if(installed STREQUAL wanted)
      return()
    endif()
  endif()

  set(advice "-DREEVE_PAGES=OFF, or REEVE_PAGES=OFF ./run explore, builds all but the interactive parts of pages and needs no npm.")
  find_program(NPM_EXECUTABLE npm)
  if(NOT NPM_EXECUTABLE)
    message(FATAL_ERROR "npm was not found; Debian's package npm has it. ${advice}")
  endif()
  # No package needs its install script, and a script that does not run cannot do harm.
  set(install "${NPM_EXECUTABLE}" ci --ignore-scripts --no-audit --no-fund --loglevel error)
  reeve_run_npm(600 ${install} --offline)
  if(NOT result EQUAL 0)
    message(STATUS "Fetching the npm packages of ${name}")
    # A short question first: `npm ci` waits for minutes for a registry that never answers.
    file(READ "${folder}/package.json" described)
    string(JSON package MEMBER "${described}" dependencies 0)
    reeve_run_npm(15 "${NPM_EXECUTABLE}" view ${package} name --fetch-retries 0)
    if(result EQUAL 0)
      reeve_run_npm(600 ${install})
    endif()
  endif()
  if(NOT result EQUAL 0)
    message(FATAL_ERROR
      "npm could not fetch the packages of ${name} (${result}):\n${said}\n"
      "Is the registry reachable? `npm config get registry` and `npm config get proxy` show which one npm asks, and how. ${advice}")
  endif()
  file(WRITE "${stamp}" "${wanted}")
endfunction()

# Runs a command in ${place} for at most so many seconds; sets ${result} and, of what it prints, ${said}.
macro(reeve_run_npm seconds)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${place}" TIMEOUT ${seconds}
                  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
endmacro()
