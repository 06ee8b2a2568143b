# reeve_library(<folder> <link libraries...>): the static library reeve_<folder>, alias
# reeve::<folder>, of every .cpp file in the current folder and its rooms.
function(reeve_library folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  if(NOT sources)
    # A static library needs a source; a young folder may have headers only.
    set(sources "${PROJECT_BINARY_DIR}/generated/empty.cpp")
    file(CONFIGURE OUTPUT "${sources}" CONTENT "")
  endif()

  add_library(reeve_${folder} STATIC ${sources})
  add_library(reeve::${folder} ALIAS reeve_${folder})
  set_target_properties(reeve_${folder} PROPERTIES EXPORT_NAME ${folder})
  target_compile_features(reeve_${folder} PUBLIC cxx_std_20)
  # Our includes are root-relative. Installed, that root is include/reeve, while others
  # write <reeve/core/version.hpp>: hence two folders.
  target_include_directories(reeve_${folder} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/reeve>)
  target_link_libraries(reeve_${folder}
    PRIVATE $<BUILD_INTERFACE:reeve_warnings>
    ${ARGN})

  install(TARGETS reeve_${folder} EXPORT reeveTargets
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/"
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/reeve/${folder}"
          FILES_MATCHING PATTERN "*.hpp")
endfunction()
