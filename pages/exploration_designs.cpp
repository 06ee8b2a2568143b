#include "pages/exploration_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "pages/exploration_words.hpp"
#include "pages/objective_title.hpp"

namespace reeve {
namespace {

// Eight digits: enough to round as the rest of the page does, and half the bytes.
Json rounded(double value) {
  const Json exact = number(value);
  return exact.is_null() ? exact : Json(std::stod(fmt::format("{:.8g}", value)));
}

class Columns {
 public:
  explicit Columns(bool uncertain) : uncertain_(uncertain) {
    for (const char* name : {"word", "name", "rank", "front", "kind"}) json_[name] = Json::array();
    json_["values"] = Json::array();
    for (std::size_t i = 0; i < objective_count; ++i) json_["values"].push_back(Json::array());
    json_["distribution"] = Json::object();
  }

  void add(const ListedDesign& design, Kind kind) {
    json_["word"].push_back(design.ranked.design.word);
    json_["name"].push_back(design.name);
    json_["rank"].push_back(design.ranked.rank);
    json_["front"].push_back(design.ranked.front);
    json_["kind"].push_back(static_cast<int>(kind));
    for (std::size_t i = 0; i < objective_count; ++i) {
      json_["values"][i].push_back(rounded(design.ranked.design.values[i]));
    }
    if (uncertain_) add(design.distribution);
  }

  Json take() { return std::move(json_); }

 private:
  void add(const std::optional<RankDistribution>& given) {
    const auto put = [&](const char* name, double RankDistribution::*part) {
      json_["distribution"][name].push_back(given ? rounded(*given.*part) : Json(nullptr));
    };
    put("first", &RankDistribution::first);
    put("median", &RankDistribution::median);
    put("low", &RankDistribution::low);
    put("high", &RankDistribution::high);
  }

  Json json_;
  bool uncertain_;
};

std::set<std::string> known_words(const ExploreReport& report) {
  std::set<std::string> words;
  for (const ReferenceStanding& reference : report.result.references) {
    words.insert(reference.design.word);
  }
  return words;
}

}  // namespace

const std::vector<ListedDesign>& listed_designs(const ExploreReport& report) {
  return report.front.size() > report.top.size() ? report.front : report.top;
}

Json design_columns(const ExploreReport& report, std::size_t most) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  Columns columns(!listed.empty() && listed.front().distribution.has_value());
  const std::set<std::string> known = known_words(report);
  std::set<std::string> held;
  for (std::size_t i = 0; i < std::min(most, listed.size()); ++i) {
    const RankedDesign& ranked = listed[i].ranked;
    const bool is_known = known.contains(ranked.design.word);
    held.insert(ranked.design.word);
    columns.add(listed[i], is_known ? Kind::known : ranked.front == 1 ? Kind::front : Kind::listed);
  }
  for (std::size_t i = 0; i < report.result.references.size(); ++i) {
    const ReferenceStanding& reference = report.result.references[i];
    if (!held.insert(reference.design.word).second) continue;
    columns.add({{reference.design, reference.front, reference.rank},
                 report.reference_names[i],
                 std::nullopt},
                Kind::known);
  }
  // What is listed has a rank, even if there is no room for it here.
  for (const ListedDesign& design : listed) held.insert(design.ranked.design.word);
  for (const Design& design : report.result.sample) {
    if (!held.contains(design.word)) columns.add({{design, 0, 0}, "", std::nullopt}, Kind::sample);
  }
  return columns.take();
}

Json chart_data(const ExploreReport& report, Json columns) {
  Json data{{"objectives", Json::array()}, {"ranking", Json::array()}};
  for (const ObjectiveRow& row : objective_table()) {
    data["objectives"].push_back({{"name", row.name},
                                  {"title", objective_title(row)},
                                  {"unit", row.unit},
                                  {"better", row.better == Better::higher ? "higher" : "lower"},
                                  {"meaning", row.meaning}});
  }
  for (const Objective objective : report.options.order.objectives) {
    data["ranking"].push_back(static_cast<std::size_t>(objective));
  }
  data["designs"] = std::move(columns);
  return data;
}

}  // namespace reeve
