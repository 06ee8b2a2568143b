// Pieces of the JSON interface that several reports share. docs/json.md describes it.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
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

// {"objectives","score","grasps","hardware","model"}
Json settings_json(const Order& order, const Score& score, const GraspSet& grasps,
                   const Model& model, std::uint64_t unconverged);

std::string objective_names(const std::vector<Objective>& objectives);

// "Front by front over uniformity_mean, efficiency_mean", "By the score, …"
std::string order_text(const Order& order, const Score& score);

std::string version_json();

}  // namespace reeve::reports
