# Sets NLOPT_LIBRARIES to the target with NLopt's C++ interface. Debian keeps that one
# in a folder of its own, beside the C library; elsewhere there is one library for both.
find_package(NLopt CONFIG QUIET NO_DEFAULT_PATH
             PATHS "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/nlopt_cxx")
if(NOT NLopt_FOUND)
  find_package(NLopt CONFIG REQUIRED)
endif()
