// Generation alone: every routing of the full parts, actuated or not, none of them evaluated.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::bench {
namespace {

// Calls visit(routing) for each of them.
template <typename Visit>
void generate_all(benchmark::State& state, const GeneratorOptions& options, Visit visit) {
  std::int64_t routings = 0;
  Routing routing;
  for (auto _ : state) {
    RoutingGenerator generator(options);
    while (generator.next(routing)) {
      ++routings;
      visit(routing);
    }
  }
  state.SetItemsProcessed(routings);
}

void keep(Routing& routing) { benchmark::DoNotOptimize(routing.tendons.data()); }

void generate(benchmark::State& state) {
  generate_all(state, full_search(static_cast<int>(state.range(0))), keep);
}

// Measures the cost of a list on paper: with the word of each.
void generate_words(benchmark::State& state) {
  generate_all(state, full_search(static_cast<int>(state.range(0))),
               [](const Routing& routing) { benchmark::DoNotOptimize(to_word(routing)); });
}

// Anchored tips and up to so many floating blocks, too.
void generate_trees(benchmark::State& state) {
  GeneratorOptions options = full_search(static_cast<int>(state.range(0)));
  options.parts.anchored = true;
  options.parts.blocks = static_cast<int>(state.range(1));
  generate_all(state, options, keep);
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
