// A stamp names the result of a file: all files that one run leaves in its folder have the same.
//
// Its id needs no clock, so that the same command writes the same bytes. It tells accidents apart,
// not forgeries.
#pragma once

#include <filesystem>
#include <string>

#include "reports/output/json.hpp"

namespace reeve::reports {

struct Stamp {
  std::string kind;  // the key in JSON, the last column of a table, the word in a comment
  std::string id;    // 16 hexadecimal digits
};

inline constexpr const char* exploration_kind = "exploration";
inline constexpr const char* result_kind = "result_id";

// FNV-1a of 64 bits over the JSON as text, its keys in their order. (Fowler, Noll, Vo:
// draft-eastlake-fnv.)
std::string hash_of(const Json& json);

// As print(), with the key `result_id` at the end: the hash of all but how long it took.
std::string print_stamped(Json json);
// The stamp of what that printed.
Stamp result_stamp(const std::string& printed);

// The text of a file of that name: a table has a last column, but for its comment lines; a page and
// a drawing end with a comment. Other text stays as it is.
std::string stamped(const std::filesystem::path& name, std::string text, const Stamp& stamp);

// The id that a file has, also in JSON; nothing where it has none of that kind, or no row.
std::string id_in(const std::filesystem::path& name, const std::string& text,
                  const std::string& kind);

}  // namespace reeve::reports
