// Generation alone: every routing of the full parts, actuated or not, none of them evaluated.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::bench {
namespace {

void generate(benchmark::State& state) {
  const GeneratorOptions options = full_search(static_cast<int>(state.range(0)));
  std::int64_t routings = 0;
  Routing routing;
  for (auto _ : state) {
    RoutingGenerator generator(options);
    while (generator.next(routing)) {
      ++routings;
      benchmark::DoNotOptimize(routing.tendons.data());
    }
  }
  state.SetItemsProcessed(routings);
}

// What a list on paper costs: the word of each, too.
void generate_words(benchmark::State& state) {
  const GeneratorOptions options = full_search(static_cast<int>(state.range(0)));
  std::int64_t routings = 0;
  Routing routing;
  for (auto _ : state) {
    RoutingGenerator generator(options);
    while (generator.next(routing)) {
      ++routings;
      benchmark::DoNotOptimize(to_word(routing));
    }
  }
  state.SetItemsProcessed(routings);
}

// Anchored tips and up to so many floating blocks, too.
void generate_trees(benchmark::State& state) {
  GeneratorOptions options = full_search(static_cast<int>(state.range(0)));
  options.parts.anchored = true;
  options.parts.blocks = static_cast<int>(state.range(1));
  std::int64_t routings = 0;
  Routing routing;
  for (auto _ : state) {
    RoutingGenerator generator(options);
    while (generator.next(routing)) {
      ++routings;
      benchmark::DoNotOptimize(routing.tendons.data());
    }
  }
  state.SetItemsProcessed(routings);
}

BENCHMARK(generate)->ArgName("fingers")->Arg(5)->Arg(6)->UseRealTime()->Unit(
    benchmark::kMillisecond);
BENCHMARK(generate_words)->ArgName("fingers")->Arg(6)->UseRealTime()->Unit(benchmark::kMillisecond);

BENCHMARK(generate_trees)
    ->ArgNames({"fingers", "blocks"})
    ->Args({5, 0})
    ->Args({5, 1})
    ->Args({4, 3})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reeve::bench
