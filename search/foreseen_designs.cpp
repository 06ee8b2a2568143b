#include "search/foreseen_designs.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "search/batches.hpp"

namespace reeve::search {
namespace {

// Returns the parts without tips and joins at the hand that have more friction than others.
PartSet of_least_friction(PartSet parts, const Hardware& hardware) {
  const bool tubes_slide_worse = hardware.tube.exponent() > hardware.bearing.exponent();
  const TipKind tip = tubes_slide_worse ? TipKind::tube : TipKind::bearing;
  const TokenKind join = tubes_slide_worse ? TokenKind::tube_join : TokenKind::bearing_join;
  if (parts.tips.size() > 1) std::erase(parts.tips, tip);
  if (parts.joins.size() > 1) std::erase(parts.joins, join);
  return parts;
}

ExploreOptions with_little_friction(ExploreOptions options) {
  options.generator.parts =
      of_least_friction(options.generator.parts, possible_hardware(options.model));
  options.sample = 0;
  options.references.clear();
  return options;
}

}  // namespace

ForeseenDesigns::ForeseenDesigns(const ExploreOptions& options, const std::atomic<bool>* stop)
    : found_(search_batches(with_little_friction(options), {}, EvaluatedDesigns::that_may_be_kept,
                            {.report = {}, .stop = stop})) {
  found_.thin_out();
}

void ForeseenDesigns::add_to(ExplorationPart& stopped) {
  std::set<std::string> kept;
  for (ArchivedDesign& member : stopped.archive.members()) {
    kept.insert(std::move(member.design.word));
  }
  for (ArchivedDesign& member : found_.archive.members()) {
    if (!kept.contains(member.design.word)) stopped.archive.add(std::move(member.design));
  }
  for (Design& design : found_.tradeoff.candidates()) stopped.tradeoff.add(std::move(design));
}

}  // namespace reeve::search
