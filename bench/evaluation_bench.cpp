// One design in all its grasps, pulling and releasing, with every objective.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::bench {
namespace {

void evaluate_design(benchmark::State& state) {
  const int fingers = static_cast<int>(state.range(0));
  const auto routings = sample_of_routings(fingers, 1000);
  const GraspSet grasps = single_grasps(fingers);
  DesignEvaluator evaluator(Hardware{}, grasps);
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(evaluator.evaluate(routings[next]));
    next = next + 1 == routings.size() ? 0 : next + 1;
  }
  state.SetItemsProcessed(state.iterations());
  const double solves = 2.0 * static_cast<double>(grasps.size());  // pull and release
  state.counters["solves_per_second"] = benchmark::Counter(
      solves * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK(evaluate_design)->ArgName("fingers")->Arg(2)->Arg(5);

}  // namespace
}  // namespace reeve::bench
