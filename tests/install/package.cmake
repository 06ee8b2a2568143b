# Builds the Debian package, looks at what it holds and depends on, extracts it into an empty folder,
# and runs the program from there with nothing of the source in reach.
find_program(dpkg_deb dpkg-deb)
find_program(shlibdeps dpkg-shlibdeps)
if(NOT dpkg_deb OR NOT shlibdeps)
  message("SKIPPED: this is no Debian, or it has no dpkg-dev")
  return()
endif()
set(work "${BUILD}/package_test")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}/root" "${work}/empty")

# run(<variable> <command...>): what it prints; any failure ends the test.
function(run variable)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${work}/empty" RESULT_VARIABLE result
                  OUTPUT_VARIABLE output ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with ${result}:\n${output}${said}")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected '${pattern}' in:\n${text}")
  endif()
endfunction()

function(expect_none text pattern)
  if(text MATCHES "${pattern}")
    message(FATAL_ERROR "expected no '${pattern}', and there is '${CMAKE_MATCH_0}'")
  endif()
endfunction()

run(said cpack --config "${BUILD}/CPackConfig.cmake" -B "${work}")
file(GLOB package "${work}/*.deb")
get_filename_component(name "${package}" NAME)
expect("${name}" "^reeve_${EXPECTED}_[a-z0-9]+\\.deb$")

run(about dpkg-deb -I "${package}")
expect("${about}" "Package: reeve\n")
expect("${about}" "Version: ${EXPECTED}\n")
expect("${about}" "Maintainer: the reeve authors\n")
foreach(library IN ITEMS "libc6 \\(>= " "libtbb12" "libnlopt" "libfmt9" "libsqlite3-0" "libtinyxml2"
                         "zlib1g" "libstdc\\+\\+6")
  expect("${about}" "\n Depends: [^\n]*${library}")
endforeach()
# These would bring Open MPI and Python to every machine.
expect_none("${about}" "\n Depends: [^\n]*(openmpi|python)")

run(files dpkg-deb -c "${package}")
foreach(file IN ITEMS bin/reeve lib/[^\n]*libreeve_core\\.a include/reeve/reeve\\.hpp
                      include/reeve/core/routing\\.hpp lib/[^\n]*cmake/reeve/reeveConfig\\.cmake
                      share/reeve/catalog/tr7\\.toml share/reeve/catalog/measured/exo_glove_ii\\.csv
                      share/man/man1/reeve\\.1\\.gz share/bash-completion/completions/reeve
                      share/doc/reeve/copyright)
  expect("${files}" " \\./usr/${file}\n")
endforeach()
expect_none("${files}" "dist-packages|_core[^\n]*\\.so|[^\n]*/usr/local/[^\n]*")

run(said dpkg-deb -x "${package}" "${work}/root")
set(reeve "${CMAKE_COMMAND}" -E env --unset=REEVE_CATALOG "${work}/root/usr/bin/reeve")
run(said ${reeve} --version)
expect("${said}" "^reeve ${EXPECTED} \\(.*\\)\nMIT licence")
run(said ${reeve} explore --fingers 2 --out "${work}/explored")
expect("${said}" "1-P-2-P-1")
if(NOT EXISTS "${work}/explored/index.html")
  message(FATAL_ERROR "explore wrote no page")
endif()
run(said ${reeve} diagnose "${work}/root/usr/share/reeve/catalog/measured/exo_glove_ii.csv")
expect("${said}" "tube_friction")

# Every subcommand and option of the program stands in the manual and the completion.
run(manual gzip -dc "${work}/root/usr/share/man/man1/reeve.1.gz")
file(READ "${work}/root/usr/share/bash-completion/completions/reeve" completion)
foreach(subcommand IN ITEMS explore rank show count check compare import simulate diagnose size merge
                            export)
  expect("${manual}" "\n\\.SS reeve ${subcommand}\n")
  run(help ${reeve} ${subcommand} --help)
  string(REGEX MATCHALL "\n  (-[a-z],)?--[a-z-]+" lines "${help}")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*(--[a-z-]+)$" "\\1" option "${line}")
    string(REPLACE "-" "\\-" in_manual "${option}")
    string(FIND "${manual}" "${in_manual}" place)
    if(NOT option STREQUAL "--help" AND place LESS 0)
      message(FATAL_ERROR "the manual has no ${option} of ${subcommand}")
    endif()
    expect("${completion}" "    ${subcommand}\\) words=\"[^\n]*${option}[ \"]")
  endforeach()
endforeach()

# The copyright file names what is compiled in.
file(READ "${work}/root/usr/share/doc/reeve/copyright" copyright)
foreach(part IN ITEMS "the reeve authors" CLI11 Mustache nlohmann-json "toml\\+\\+" Random123 SQLiteCpp
                      Eigen Boost Vega d3-ease)
  expect("${copyright}" "${part}")
endforeach()
