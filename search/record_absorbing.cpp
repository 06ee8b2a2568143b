#include <memory>
#include <optional>
#include <utility>

#include "numerics/parallel.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/pieces.hpp"
#include "search/record_parts.hpp"

namespace reeve::search {
namespace {

constexpr std::size_t at_a_time = 16;

// With options of its own.
class RecordAbsorber {
 public:
  RecordAbsorber(ExploreOptions options, bool with_all_values)
      : options_(std::move(options)), workers_(options_.threads) {
    for (std::size_t w = 0; w < workers_.count(); ++w) {
      deciding_.emplace_back(options_.model, options_.grasps, options_.score, options_.prices,
                             deciding_objectives(options_));
      if (!with_all_values) continue;
      in_full_.emplace_back(options_.model, options_.grasps, options_.score, options_.prices);
    }
  }

  void absorb(ExplorationPart& whole, const ShardRecord& record) {
    ExplorationPart part = counted_part(record, options_);
    add(
        archived_words(record), [&](const ObjectiveValues& v) { return whole.archive.may_rank(v); },
        [&](Design design, std::size_t i) {
          part.archive.add(std::move(design), record.archive[i].equals_left_out);
        });
    add(
        record.rungs, [&](const ObjectiveValues& v) { return whole.ladder.may_be_rung(v); },
        [&](Design design, std::size_t) { part.ladder.add(std::move(design)); });
    whole.absorb(std::move(part));
  }

 private:
  template <typename Wanted, typename Add>
  void add(const std::vector<std::string>& words, const Wanted& wanted, const Add& add_design) {
    const std::vector<Routing> routings = generated_routings(words, options_);
    std::vector<std::optional<Design>> designs(words.size());
    workers_.for_each_block(words.size(), at_a_time, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const ObjectiveValues values = deciding_[block.worker].evaluate(routings[i]);
        if (!wanted(values)) continue;
        designs[i] = {words[i],
                      in_full_.empty() ? values : in_full_[block.worker].evaluate(routings[i])};
      }
    });
    for (std::size_t i = 0; i < designs.size(); ++i) {
      if (designs[i]) add_design(std::move(*designs[i]), i);
    }
  }

  ExploreOptions options_;
  Workers workers_;
  std::vector<DecidingEvaluator> deciding_;  // one for each thread
  std::vector<DesignEvaluator> in_full_;     // likewise, or none
};

}  // namespace

RecordAbsorbing record_absorbing(const ExploreOptions& options, bool with_all_values) {
  return
      [absorber = std::make_shared<RecordAbsorber>(options, with_all_values)](
          ExplorationPart& whole, const ShardRecord& record) { absorber->absorb(whole, record); };
}

}  // namespace reeve::search
