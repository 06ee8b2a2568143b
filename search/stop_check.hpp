// A stop that is asked for on a long way from step to step, where no result can be had half-way.
#pragma once

#include <atomic>

#include "numerics/floors.hpp"

namespace reeve::search {

// Thrown, and caught by who set the check.
struct WayStopped {};

class StopCheck {
 public:
  StopCheck() = default;
  // Nothing: never.
  explicit StopCheck(const std::atomic<bool>* stop) : stop_(stop) {}

  // Of each step, some microseconds; looks at the flag some hundred times a second.
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
