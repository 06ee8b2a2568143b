// The main job end to end: generate, evaluate, keep the best, rank.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "search/explore.hpp"

namespace reeve::bench {
namespace {

void explore_all(benchmark::State& state) {
  ExploreOptions options;
  options.generator = full_search(static_cast<int>(state.range(0)));
  options.grasps = single_grasps(options.generator.fingers);
  options.threads = static_cast<int>(state.range(1));
  std::uint64_t designs = 0;
  for (auto _ : state) {
    const ExploreResult result = explore(options);
    designs += result.evaluated;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(designs));
}

BENCHMARK(explore_all)
    ->ArgNames({"fingers", "threads"})
    ->ArgsProduct({{4, 5}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reeve::bench
