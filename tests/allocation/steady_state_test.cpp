// From a routing to its tensions without the heap, once the memory of the first calls is there.
// This test has a binary of its own, since it replaces the global operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "core/tension.hpp"
#include "tests/support/random_routing.hpp"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace reeve {
namespace {

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

long allocations_of_one_pass(const std::vector<Prepared>& trials, Workspace& workspace) {
  const long before = allocations;
  for (const auto& [trial, builder] : trials) solve(trial, builder, workspace);
  return allocations - before;
}

TEST(Allocation, IsCounted) {
  const long before = allocations;
  void* memory = ::operator new(16);  // unlike a new expression, never optimised away
  ::operator delete(memory);
  EXPECT_EQ(allocations - before, 1);
}

TEST(Allocation, SolvingAllocatesNothingOnceWarm) {
  const std::vector<Prepared> trials = random_trials(500);
  Workspace workspace;
  EXPECT_GT(allocations_of_one_pass(trials, workspace), 0);
  // Buffers are handed on between the solver and its caller: each has to grow once.
  allocations_of_one_pass(trials, workspace);
  EXPECT_EQ(allocations_of_one_pass(trials, workspace), 0);
}

}  // namespace
}  // namespace reeve
