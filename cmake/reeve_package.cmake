# `cpack` in the build folder, or ./run package: the Debian package. It leaves out the Python module,
# which is a wheel, and what mpirun loads, which would ask for Open MPI on every machine.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME reeve)
set(CPACK_PACKAGE_CONTACT "the reeve authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "explore, rank and diagnose tendon routings of wearable robots")
set(CPACK_PACKAGE_DESCRIPTION
  "reeve enumerates the ways in which one motor's tendon can be led through the
fingers of a soft wearable hand, ranks them by a friction model, checks itself
against published routings, and diagnoses what a real rig does otherwise.
The package has the program, its C++ library with headers, and the catalogue.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
# The build's own component alone. A package is made of a tree that is built: ./run package.
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};reeve;Unspecified;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What a program that links the library needs besides.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "g++, cmake, libeigen3-dev, libboost-graph-dev, libtbb-dev, libfmt-dev, libtomlplusplus-dev, libsqlitecpp-dev, libsqlite3-dev, libtinyxml2-dev, libnlopt-cxx-dev, zlib1g-dev")
include(CPack)

set(REEVE_PACKAGED reeve reeve_manual)
foreach(folder IN LISTS REEVE_FLOORS)
  list(APPEND REEVE_PACKAGED reeve_${folder})
endforeach()
add_custom_target(reeve_packaged DEPENDS ${REEVE_PACKAGED})
