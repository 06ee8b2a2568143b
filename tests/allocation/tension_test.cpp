// From a routing to its tensions without the heap, once the memory of the first calls is there.
#include "core/tension/tension.hpp"

#include <cstdint>
#include <vector>

#include "tests/allocation/allocations.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

using testing::Allocation;
using testing::Trial;

// What a search keeps from one routing to the next.
struct Workspace {
  Network network;
  Mechanics mechanics;
  TensionSolver solver;
  TensionState state;
};

void solve(const Trial& trial, const MechanicsBuilder& builder, Workspace& workspace) {
  expand(trial.routing, workspace.network);
  builder.apply(workspace.network, workspace.mechanics);
  workspace.solver.solve(workspace.network, workspace.mechanics, trial.grasp, trial.direction,
                         workspace.state);
}

struct Prepared {
  Trial trial;
  MechanicsBuilder builder;
};

std::vector<Prepared> random_trials(int count) {
  std::vector<Prepared> prepared;
  for (int seed = 1; seed <= count; ++seed) {
    const Trial trial = testing::random_trial(static_cast<std::uint64_t>(seed));
    prepared.push_back({trial, MechanicsBuilder(trial.hardware)});
  }
  return prepared;
}

std::uint64_t allocations_of_one_pass(const std::vector<Prepared>& trials, Workspace& workspace) {
  return testing::allocations_in([&] {
    for (const auto& [trial, builder] : trials) solve(trial, builder, workspace);
  });
}

TEST_F(Allocation, SolvingAllocatesNothingOnceWarm) {
  const std::vector<Prepared> trials = random_trials(500);
  Workspace workspace;
  EXPECT_GT(allocations_of_one_pass(trials, workspace), 0U);
  // Buffers are handed on between the solver and its caller: each has to grow once.
  allocations_of_one_pass(trials, workspace);
  EXPECT_EQ(allocations_of_one_pass(trials, workspace), 0U);
}

}  // namespace
}  // namespace reeve
