#include "reports/exploration/listed_design_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reports/exploration/design_list.hpp"
#include "reports/output/json_text.hpp"

namespace reeve {
namespace {

using reports::Json;

ListedDesign plain_design() {
  ListedDesign design;
  design.ranked.design.word = "M-1b-B-2-F";
  design.ranked.rank = 12;
  design.ranked.front = 3;
  design.place = 11;
  for (const ObjectiveRow& row : objective_table()) {
    const auto i = static_cast<std::size_t>(row.objective);
    design.ranked.design.values[i] = row.of_hand ? 0 : 0.1 + static_cast<double>(i);
  }
  return design;
}

std::vector<ListedDesign> all_kinds() {
  std::vector<ListedDesign> designs(7, plain_design());
  designs[1].name = "a \"name\"\n\xff";
  designs[2].equivalent = {"M-1b-B-2b-F"};
  designs[3].equivalent = {"M-1-B-2b-F", "M-1b-B-2b-F"};
  designs[4].same_as = "M-1-B-2-F";
  designs[5].distribution = RankDistribution{0.5, 2, 1, 7};
  designs[5].bands = {{Objective::uniformity_mean, {0.25, 0.5, 0.75}}};
  designs[6].constraints_met = 0.5;
  for (std::size_t i = 0; i < 7; ++i) {
    designs.push_back(designs[i]);
    for (const ObjectiveRow& row : objective_table()) {
      if (!row.of_hand) continue;
      const auto k = static_cast<std::size_t>(row.objective);
      designs.back().ranked.design.values[k] = 0.7 + static_cast<double>(k);
    }
  }
  ObjectiveValues& odd = designs.back().ranked.design.values;
  odd[static_cast<std::size_t>(Objective::cost)] = std::numeric_limits<double>::infinity();
  odd[static_cast<std::size_t>(Objective::uniformity_mean)] =
      std::numeric_limits<double>::quiet_NaN();
  return designs;
}

TEST(ListedDesignText, IsWhatTheJsonPrints) {
  reports::ListedDesignText texts;
  for (const ListedDesign& design : all_kinds()) {
    reports::ObjectText text;
    text.add_text_list("top", std::vector<ListedDesign>(2, design),
                       [&](std::string& to, const ListedDesign& one) { texts.append(to, one); });
    const Json entry = to_json(design);
    EXPECT_EQ(std::move(text).text(), reports::print(Json{{"top", {entry, entry}}}));
  }
}

}  // namespace
}  // namespace reeve
