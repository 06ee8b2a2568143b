// Progress and cancellation callbacks of a long study.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "search/explore.hpp"

namespace reeve::studies {

// Both may be empty.
struct StudySupervision {
  // Called now and then: what is being done, and how far it is.
  std::function<void(const std::string& stage, const Progress&)> report{};
  const std::atomic<bool>* stop = nullptr;

  Supervision during(const std::string& stage) const {
    if (!report) return {{}, stop};
    return {[report = report, stage](const Progress& progress) { report(stage, progress); }, stop};
  }
  bool stopped() const { return stop != nullptr && stop->load(); }
};

}  // namespace reeve::studies
