# reeve_embed(<folder> <header> <function> FILES <name=file...> DEPENDS <files...>): the library
# reeve_<folder> gets the function that the header declares: the content of files, by name. Written
# again when one of those in DEPENDS is newer.
function(reeve_embed folder header function)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "FILES;DEPENDS")
  set(script "${PROJECT_SOURCE_DIR}/cmake/embed.cmake")
  set(embedded "${PROJECT_BINARY_DIR}/generated/${function}.cpp")
  list(JOIN arg_FILES "|" files)
  add_custom_command(OUTPUT "${embedded}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${embedded}" "-DHEADER=${header}"
            "-DFOLDER=${folder}" "-DFUNCTION=${function}" "-DFILES=${files}" -P "${script}"
    DEPENDS ${arg_DEPENDS} "${script}"
    COMMENT "Embedding the files of ${folder}" VERBATIM)
  target_sources(reeve_${folder} PRIVATE "${embedded}")
  # Its `using namespace` is its own.
  set_source_files_properties("${embedded}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
