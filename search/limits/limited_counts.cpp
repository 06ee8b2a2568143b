#include "search/limits/limited_counts.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "search/limits/part_classes.hpp"

namespace reeve::search {
namespace {

void require_decided(const std::vector<Constraint>& constraints, const GeneratorOptions& options) {
  for (const Constraint& constraint : constraints) {
    if (counts_parts(constraint.objective)) continue;
    throw InputError({.what = "constraint",
                      .value = constraint.text,
                      .expected = "one on sheaths, pulleys, knots, blocks or parts, since others "
                                  "need each design's tensions: explore counts what they reject"});
  }
  const std::size_t decided = decided_by_parts(constraints, options);
  if (decided == constraints.size()) return;
  throw InputError({.what = "constraint",
                    .value = constraints[decided].text,
                    .expected = fmt::format("fewer constraints or smaller bounds: together they "
                                            "tell more than {} sums of parts apart",
                                            most_classes / 2)});
}

std::vector<std::uint64_t> verdicts(const GeneratorOptions& options,
                                    const std::vector<Constraint>& constraints) {
  RoutingGenerator generator(options, {constraints, options});
  return generator.verdicts_before(generator.total());
}

}  // namespace

LimitedCounts count_limited(const GeneratorOptions& options,
                            const std::vector<Constraint>& constraints) {
  if (options.identity == FingerIdentity::distinct) {
    throw InputError("constraints are counted for fingers that are not told apart");
  }
  require_decided(constraints, options);
  GeneratorOptions of_one = options;
  of_one.one_tendon = true;
  const std::vector<std::uint64_t> any = verdicts(options, constraints);
  LimitedCounts counts{any[within_limits], verdicts(of_one, constraints)[within_limits], {}};
  for (std::size_t c = 0; c < constraints.size(); ++c) counts.rejected.push_back(any[failing(c)]);
  return counts;
}

}  // namespace reeve::search
