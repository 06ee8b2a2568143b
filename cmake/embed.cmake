# cmake -DOUTPUT=<cpp> -DHEADER=<its header> -DFUNCTION=<its name> -DFILES=<name=file|name=file…>
#       -P embed.cmake
# Writes a function that gives files as raw strings, by name.
string(REPLACE "|" ";" FILES "${FILES}")
set(entries "")
foreach(entry IN LISTS FILES)
  string(REGEX MATCH "^([^=]+)=(.+)$" _ "${entry}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${CMAKE_MATCH_2}" content)
  string(APPEND entries "    {\"${name}\", R\"reeve_file(${content})reeve_file\"sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"\n
using namespace std::string_view_literals;\n
namespace reeve::${FOLDER} {\n
const std::map<std::string_view, std::string_view>& ${FUNCTION}() {
  static const std::map<std::string_view, std::string_view> table{
${entries}  };
  return table;
}\n
}  // namespace reeve::${FOLDER}\n")
