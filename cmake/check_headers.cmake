# One source per header of ours that has none, including only that header: it must not lean on what
# others happened to include before it. A source includes its own header first (scripts/check_layers), so
# that REEVE_UNITY=OFF checks the rest. And one that includes them all: no two may mean different things by
# one name.
set(folders ${REEVE_FLOORS} reeve cli)
list(TRANSFORM folders APPEND "/*.hpp")
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS ${folders})
set(sources "${PROJECT_BINARY_DIR}/generated/empty.cpp")
file(CONFIGURE OUTPUT "${sources}" CONTENT "")
set(together "")
foreach(header IN LISTS headers)
  string(APPEND together "#include \"${header}\"\n")
  string(REPLACE ".hpp" ".cpp" source "${header}")
  if(EXISTS "${PROJECT_SOURCE_DIR}/${source}")
    continue()
  endif()
  string(PREPEND source "${PROJECT_BINARY_DIR}/generated/alone/")
  file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n")
  list(APPEND sources "${source}")
endforeach()
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/generated/all_headers.cpp" CONTENT "${together}")
list(APPEND sources "${PROJECT_BINARY_DIR}/generated/all_headers.cpp")

add_library(reeve_headers_alone OBJECT ${sources})
set_target_properties(reeve_headers_alone PROPERTIES UNITY_BUILD OFF)
# Whether they compile is all that is asked; whatever the preset does to code costs time here.
target_compile_options(reeve_headers_alone PRIVATE -O0 -g0 -fno-sanitize=all)
target_link_libraries(reeve_headers_alone PRIVATE
  reeve_warnings reeve::reeve Boost::headers nlohmann_json::nlohmann_json CLI11::CLI11
  fmt::fmt)
if(REEVE_TESTS)
  add_test(NAME headers.compile_alone
           COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}"
                   --target reeve_headers_alone)
  set_tests_properties(headers.compile_alone PROPERTIES LABELS headers TIMEOUT 300)
endif()
