// Measures the cost of an exploration's page beside the search that it shows.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "bench/hand.hpp"
#include "pages/exploration/exploration_page.hpp"
#include "reports/exploration/design_list.hpp"
#include "search/explore.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::bench {
namespace {

ExploreReport explored(int fingers, const Catalogue& catalogue) {
  ExploreOptions options;
  options.generator = full_search(fingers);
  options.grasps = single_grasps(fingers);
  options.threads = 1;
  ExploreResult result = explore(options);
  return explore_report(options, std::move(result), {}, catalogue);
}

// All that `reeve explore` does and writes but for the page and its figures.
void explore_tables(benchmark::State& state) {
  const Catalogue catalogue;
  for (auto _ : state) {
    const ExploreReport report = explored(static_cast<int>(state.range(0)), catalogue);
    benchmark::DoNotOptimize(design_csv(report.top));
    benchmark::DoNotOptimize(design_csv(report.front));
    benchmark::DoNotOptimize(sample_csv(report.result.sample));
    benchmark::DoNotOptimize(explore_summary_json(report));
  }
}

void explore_page(benchmark::State& state) {
  const Catalogue catalogue;
  const ExploreReport report = explored(static_cast<int>(state.range(0)), catalogue);
  const ExplorationView view{report, "reeve explore", "",
                             [&](const Routing& routing) {
                               return solved_routing(routing, report.options.model,
                                                     report.options.grasps, Direction::pull,
                                                     catalogue);
                             },
                             static_cast<std::size_t>(state.range(1))};
  for (auto _ : state) benchmark::DoNotOptimize(exploration_page(view));
}

BENCHMARK(explore_tables)->ArgName("fingers")->DenseRange(2, 5)->Unit(benchmark::kMillisecond);
BENCHMARK(explore_page)
    ->ArgNames({"fingers", "details"})
    ->ArgsProduct({{4}, {0, 34, 1000}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reeve::bench
