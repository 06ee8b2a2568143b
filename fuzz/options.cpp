#include <string>

#include "core/grasp.hpp"
#include "fuzz/fuzzed.hpp"
#include "readings/reading_options.hpp"
#include "search/enumerate/parts.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/evaluate/score.hpp"
#include "search/explore.hpp"
#include "search/rank/tradeoff.hpp"
#include "search/uncertainty/sweep.hpp"
#include "sizing/dimension.hpp"
#include "sizing/goal.hpp"

namespace reeve::fuzz {
namespace {

using Option = void (*)(const std::string&);

const std::vector<Option>& all_options() {
  static const std::vector<Option> all{
      [](const std::string& text) { search::parse_objectives(text); },
      [](const std::string& text) { search::parse_constraint(text); },
      [](const std::string& text) { search::parse_score(text); },
      [](const std::string& text) { sizing::parse_dimensions(text); },
      [](const std::string& text) { sizing::parse_goal(text); },
      [](const std::string& text) { sizing::parse_target(text, 3); },
      [](const std::string& text) { sizing::parse_varied(text); },
      [](const std::string& text) { sizing::parse_equal(text); },
      [](const std::string& text) { search::parse_sweep(text); },
      [](const std::string& text) { search::parse_within(text); },
      [](const std::string& text) { search::parse_tips(text); },
      [](const std::string& text) { search::parse_joins(text); },
      [](const std::string& text) { search::parse_ends(text); },
      [](const std::string& text) { search::parse_shard(text); },
      [](const std::string& text) { core::parse_grasp(text, 3); },
      [](const std::string& text) { core::parse_grasps(text, 3); },
      [](const std::string& text) { diagnosis::parse_column_noise(text); },
      [](const std::string& text) { diagnosis::parse_column_meaning(text); },
      [](const std::string& text) { diagnosis::parse_column_unit(text); },
  };
  return all;
}

}  // namespace

void options(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::size_t which = static_cast<unsigned char>(bytes.front()) % all_options().size();
  or_refused([&] { all_options()[which](std::string(bytes.substr(1))); });
}

}  // namespace reeve::fuzz
