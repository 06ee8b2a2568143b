#include "search/record_parts.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "search/routing_source.hpp"

namespace reeve::search {
namespace {

Routing generated_routing(const std::string& word, const ExploreOptions& options) {
  Routing routing = parse_routing(word);
  if (finger_count(routing) == options.generator.fingers && is_actuated(routing)) return routing;
  throw InputError({.what = "routing",
                    .value = word,
                    .expected = fmt::format("one of {} fingers that the motor pulls",
                                            options.generator.fingers)});
}

}  // namespace

std::vector<Routing> generated_routings(const std::vector<std::string>& words,
                                        const ExploreOptions& options) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(generated_routing(word, options));
  return routings;
}

ExplorationPart counted_part(const ShardRecord& record, const ExploreOptions& options) {
  ExplorationPart part(options);
  part.total = record.total;
  part.generated = record.generated;
  part.evaluated = record.evaluated;
  part.unconverged = record.unconverged;
  part.seconds = record.seconds;
  part.constraint_failures = record.constraint_failures;
  if (pruning_constraints(options) == 0) part.reaches = ConstraintReaches(record.reaches);
  part.references = record.references;
  for (const SampledWord& sampled : record.sample) {
    part.sample.add(sampled.place, generated_routing(sampled.word, options));
  }
  return part;
}

std::vector<std::string> archived_words(const ShardRecord& record) {
  std::vector<std::string> words;
  for (const ArchivedWord& archived : record.archive) words.push_back(archived.word);
  return words;
}

}  // namespace reeve::search
