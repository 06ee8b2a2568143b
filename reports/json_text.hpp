// A JSON object as print() would print it, member by member: of a long list only one entry at a
// time is there as JSON, which takes several times the memory of its text.
#pragma once

#include <string>
#include <string_view>

#include "reports/json.hpp"

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
    const char* between = "\n";
    for (const auto& entry : entries) {
      add_entry(between, to_json(entry));
      between = ",\n";
    }
    text_ += "\n  ]";
  }

  // Of all members.
  std::string text() &&;

 private:
  void begin_member(std::string_view key);
  void add_entry(std::string_view before, const Json& entry);

  std::string text_;
};

}  // namespace reeve::reports
