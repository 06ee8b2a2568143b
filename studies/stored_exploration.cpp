#include "studies/stored_exploration.hpp"

namespace reeve::studies {
namespace {

// Some 100 MB of log.
constexpr std::uint64_t most_at_a_time = 300000;

}  // namespace

Checkpoint checkpoint_in(ExplorationStore& store, std::chrono::seconds every) {
  using Clock = std::chrono::steady_clock;
  Checkpoint checkpoint;
  checkpoint.before = store.record();
  if (store.keep() == Keep::all) {
    checkpoint.design = [&store](const EvaluatedDesign& design) { store.add(design); };
  }
  checkpoint.is_due = [&store, every, last = Clock::now()]() mutable {
    const bool is_due = Clock::now() - last >= every || store.added_since_save() >= most_at_a_time;
    if (is_due) last = Clock::now();
    return is_due;
  };
  checkpoint.save = [&store](ExplorationPart& so_far) { store.save(so_far); };
  return checkpoint;
}

}  // namespace reeve::studies
