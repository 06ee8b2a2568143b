# cmake -DSOURCE=<root> -DOUTPUT=<header> -DNUMBER=<version> -P version.cmake
# Runs on every build; writes the header only when its text changed, so that a new
# commit recompiles core/version.cpp and nothing else.
set(commit "unknown")
# Without this test a copy unpacked inside somebody else's checkout would name that one.
if(EXISTS "${SOURCE}/.git")
  execute_process(
    COMMAND git -c "safe.directory=${SOURCE}" --no-optional-locks describe --always --dirty
    WORKING_DIRECTORY "${SOURCE}"
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET RESULT_VARIABLE result)
  if(result EQUAL 0)
    set(commit "${described}")
  endif()
  # Two programs with other changes are two programs: a store of the one is none of the other's.
  if(commit MATCHES "-dirty$")
    execute_process(
      COMMAND git -c "safe.directory=${SOURCE}" --no-optional-locks diff-index -p --full-index
              --no-ext-diff --no-textconv --no-color HEAD -- . ":(exclude)tests" ":(exclude)docs" ":(exclude)*.md"
      WORKING_DIRECTORY "${SOURCE}"
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      string(SHA1 digest "${changes}")
      string(SUBSTRING "${digest}" 0 8 digest)
      string(APPEND commit "-${digest}")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
#pragma once
#define REEVE_VERSION_NUMBER "@NUMBER@"
#define REEVE_VERSION_COMMIT "@commit@"
]])
