// Request to stop a long walk from step to step, which has no result half-way.
#pragma once

#include <atomic>

#include "numerics/floors.hpp"

namespace reeve::search {

// Caught by the code that set the check.
struct WayStopped {};

class StopCheck {
 public:
  StopCheck() = default;
  // nullptr: never stops.
  explicit StopCheck(const std::atomic<bool>* stop) : stop_(stop) {}

  // Call it on each step of some microseconds. It reads the flag some hundred times a second.
  void step() {
    constexpr unsigned every = 1024;
    if (stop_ == nullptr || ++steps_ % every != 0) return;
    if (stop_->load()) throw WayStopped{};
  }

 private:
  const std::atomic<bool>* stop_ = nullptr;
  unsigned steps_ = 0;
};

}  // namespace reeve::search
