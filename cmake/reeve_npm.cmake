# reeve_npm_packages(<name> <folder> <variable>): what <folder>/package-lock.json names, exactly
# that, in ${PROJECT_BINARY_DIR}/npm/<name>/node_modules. The variable gets a file to depend on.
find_program(NPM_EXECUTABLE npm REQUIRED)
function(reeve_npm_packages name folder variable)
  set(place "${PROJECT_BINARY_DIR}/npm/${name}")
  set(files "${folder}/package.json" "${folder}/package-lock.json" "${folder}/.npmrc")
  set(stamp "${place}/installed")
  # No package needs its install script, and what does not run cannot do harm.
  add_custom_command(OUTPUT "${stamp}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${place}"
    COMMAND "${CMAKE_COMMAND}" -E copy ${files} "${place}"
    COMMAND "${CMAKE_COMMAND}" -E chdir "${place}"
            "${NPM_EXECUTABLE}" ci --ignore-scripts --no-audit --no-fund --prefer-offline
            --loglevel error
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${files}
    COMMENT "Fetching the npm packages of ${name}" VERBATIM)
  set(${variable} "${stamp}" PARENT_SCOPE)
endfunction()
