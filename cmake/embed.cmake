# cmake -DOUTPUT=<cpp> -DFILES=<name=file|name=file…> -P embed.cmake
# Writes the table of pages/asset_table.hpp: files as raw strings.
string(REPLACE "|" ";" FILES "${FILES}")
set(entries "")
foreach(entry IN LISTS FILES)
  string(REGEX MATCH "^([^=]+)=(.+)$" _ "${entry}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${CMAKE_MATCH_2}" content)
  string(APPEND entries "    {\"${name}\", R\"reeve_asset(${content})reeve_asset\"sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"pages/asset_table.hpp\"\n
using namespace std::string_view_literals;\n
namespace reeve {\n
const std::map<std::string_view, std::string_view>& asset_table() {
  static const std::map<std::string_view, std::string_view> table{
${entries}  };
  return table;
}\n
}  // namespace reeve\n")
