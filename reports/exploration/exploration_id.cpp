#include "reports/exploration/exploration_id.hpp"

#include "core/notation.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::reports {

std::string whole_exploration_id(const ExploreReport& report) {
  Json asked = explore_settings(report);
  asked["shard"] = "1/1";
  // Counted on the way, not asked.
  if (asked["model"].is_object()) asked["model"].erase("unconverged");
  Json known = Json::array();
  for (std::size_t i = 0; i < report.options.references.size(); ++i) {
    known.push_back({report.reference_names[i], to_word(report.options.references[i])});
  }
  return hash_of({asked, known, version_json()});
}

std::string exploration_id(const ExploreReport& report) {
  std::string whole = whole_exploration_id(report);
  const Shard& shard = report.options.shard;
  const ExploreResult& result = report.result;
  if (shard.count == 1 && !result.partial && !report.draws_stopped) return whole;
  return hash_of(
      {whole, shard.index, shard.count, result.partial, result.generated, report.draws_stopped});
}

}  // namespace reeve::reports
