// One tension solve: kinematics, directions and tensions of a routing that is already a network.
#include <benchmark/benchmark.h>

#include "bench/hand.hpp"
#include "core/tension/tension.hpp"

namespace reeve::bench {
namespace {

void solve(benchmark::State& state, const char* word, std::uint64_t held, Direction direction) {
  const Prepared prepared = prepare(word);
  TensionSolver solver;
  TensionState tensions;
  for (auto _ : state) {
    solver.solve(prepared.network, prepared.mechanics, Grasp{held}, direction, tensions);
    benchmark::DoNotOptimize(tensions.tension.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations());
}

// Held fingers are bits: 0b1 is finger 1.
BENCHMARK_CAPTURE(solve, open_two_fingers_TR1, "M-1-T-2-F", 0b1, Direction::pull);
BENCHMARK_CAPTURE(solve, loop_two_fingers_TR7, "1-P-2-P-1", 0b1, Direction::pull);
BENCHMARK_CAPTURE(solve, loop_two_fingers_TR7_release, "1-P-2-P-1", 0b1, Direction::release);
BENCHMARK_CAPTURE(solve, loop_five_fingers, "1-P-2-P-3-P-4-P-5-P-1", 0b1, Direction::pull);
BENCHMARK_CAPTURE(solve, several_tendons_five_fingers, "M-1-T-2-F+M-3b-P-4-F+M-5-M", 0b1,
                  Direction::pull);
BENCHMARK_CAPTURE(solve, block_two_fingers, "M-Y1+1x-Y1-2x", 0b1, Direction::pull);
BENCHMARK_CAPTURE(solve, loop_through_a_block, "M-1-Y1+2-Y1-3-T-2", 0b10, Direction::pull);
BENCHMARK_CAPTURE(solve, three_blocks_five_fingers, "M-5-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", 0b1,
                  Direction::pull);
BENCHMARK_CAPTURE(solve, jam_five_fingers, "M-1-P-2-T-3-B-4-P-5-M", 0b11111, Direction::pull);

}  // namespace
}  // namespace reeve::bench
