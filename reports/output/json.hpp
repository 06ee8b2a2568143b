// Pieces of the JSON interface that several reports share. docs/schema describes it.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/part_prices.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::reports {

using Json = nlohmann::ordered_json;

// Two spaces, and a line end. Text that is no UTF-8 is shown with replacement characters.
std::string print(const Json& json);

// null where there is no number.
Json number(double value);
Json text_or_null(const std::string& text);  // null where it is empty

template <typename Value, typename ToJson>
Json value_or_null(const std::optional<Value>& value, ToJson to_json) {
  return value ? to_json(*value) : Json(nullptr);
}

// An array with what `to_json` makes of each value.
template <typename Values, typename ToJson>
Json list_json(const Values& values, ToJson to_json) {
  Json json = Json::array();
  for (const auto& value : values) json.push_back(to_json(value));
  return json;
}

// {"uniformity":{"mean","worst"},"efficiency":{"mean","worst"},"force_transmission",…}
void add_objectives(Json& target, const ObjectiveValues& values);

Json to_json(const Hardware& hardware);
Json to_json(const UncertaintyOptions& options);
Json to_json(const PartPrices& prices);
// Travels of the carriages, if the grasp gives them.
void add_ends(Json& target, const Grasp& grasp);
Json to_json(const GraspSet& grasps);

// {"objectives","score","grasps","hardware","model"}
Json settings_json(const Order& order, const Score& score, const GraspSet& grasps,
                   const Model& model, std::uint64_t unconverged);

std::string objective_names(const std::vector<Objective>& objectives);

// "Sorted by Pareto front (uniformity_mean, efficiency_mean)", "By the score, …"
std::string order_text(const Order& order, const Score& score);

std::string version_json();

// A JSON object as print() would print it, member by member: of a long list only one entry at a
// time is there as JSON, which takes several times the memory of its text.
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

  // Returns the text of all members.
  std::string text() &&;

 private:
  // As print() prints it, but for the last line end; lines after the first begin with `indent`.
  void append_indented(const Json& json, std::string_view indent);
  void begin_member(std::string_view key);
  void make_room(std::size_t entries, std::size_t begin, std::size_t done);

  std::string text_;
};

}  // namespace reeve::reports
