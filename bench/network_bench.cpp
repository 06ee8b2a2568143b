// From a routing to its network and the numbers of its contacts: once for each design.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "core/network.hpp"

namespace reeve::bench {
namespace {

void expand_network(benchmark::State& state) {
  const auto routings = sample_of_routings(static_cast<int>(state.range(0)), 1000);
  Network network;
  std::size_t next = 0;
  for (auto _ : state) {
    expand(routings[next], network);
    next = next + 1 == routings.size() ? 0 : next + 1;
    benchmark::DoNotOptimize(network.segments.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations());
}

void apply_mechanics(benchmark::State& state) {
  std::vector<Network> networks;
  for (const Routing& routing : sample_of_routings(static_cast<int>(state.range(0)), 1000)) {
    networks.push_back(expand(routing));
  }
  const MechanicsBuilder builder{Hardware{}};
  Mechanics values;
  std::size_t next = 0;
  for (auto _ : state) {
    builder.apply(networks[next], values);
    next = next + 1 == networks.size() ? 0 : next + 1;
    benchmark::DoNotOptimize(values.decay.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(expand_network)->ArgName("fingers")->Arg(2)->Arg(5);
BENCHMARK(apply_mechanics)->ArgName("fingers")->Arg(2)->Arg(5);

}  // namespace
}  // namespace reeve::bench
