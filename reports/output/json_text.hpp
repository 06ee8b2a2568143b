// A JSON object as print() would print it, member by member: of a long list only one entry at a
// time is there as JSON, which takes several times the memory of its text.
#pragma once

#include <string>
#include <string_view>

#include "reports/output/json.hpp"

namespace reeve::reports {

class ObjectText {
 public:
  void add(std::string_view key, const Json& value);
  void add_members(const Json& object);

  template <typename Entries, typename ToJson>
  void add_list(std::string_view key, const Entries& entries, ToJson to_json) {
    if (entries.empty()) {
      add(key, Json::array());
      return;
    }
    begin_member(key);
    text_ += '[';
    const std::size_t begin = text_.size();
    const char* between = "\n    ";
    std::size_t done = 0;
    for (const auto& entry : entries) {
      text_ += between;
      append_indented(to_json(entry), "    ");
      between = ",\n    ";
      make_room(entries.size(), begin, ++done);
    }
    text_ += "\n  ]";
  }

  // Of all members.
  std::string text() &&;

 private:
  // As print() prints it, but for the last line end; lines after the first begin with `indent`.
  void append_indented(const Json& json, std::string_view indent);
  void begin_member(std::string_view key);
  void make_room(std::size_t entries, std::size_t begin, std::size_t done);

  std::string text_;
};

}  // namespace reeve::reports
