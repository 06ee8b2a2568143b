#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "reports/output/json.hpp"

namespace reeve {
namespace {

using reports::Json;
using reports::ObjectText;

Json entry_of(int number) {
  return {
      {"number", number}, {"list", {1.5, nullptr, "a\nb"}}, {"object", {{"none", Json::array()}}}};
}

TEST(JsonText, IsWhatTheWholeObjectPrints) {
  const Json head{{"a \"key\"", 1}, {"text", "\xff no UTF-8"}, {"object", Json::object()}};
  for (const std::vector<int>& numbers : {std::vector<int>{}, {7}, {1, 2, 3}}) {
    Json whole = head;
    whole["numbers"] = Json::array();
    for (const int number : numbers) whole["numbers"].push_back(entry_of(number));
    whole["last"] = entry_of(0);
    ObjectText text;
    text.add_members(head);
    text.add_list("numbers", numbers, entry_of);
    text.add("last", entry_of(0));
    EXPECT_EQ(std::move(text).text(), reports::print(whole));
  }
  EXPECT_EQ(ObjectText().text(), reports::print(Json::object()));
}

}  // namespace
}  // namespace reeve
