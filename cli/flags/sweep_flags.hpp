// Options of `explore` and `rank` to show designs over one coefficient.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "search/uncertainty/sweep.hpp"

namespace reeve::cli {

struct SweepFlags {
  std::string text;

  void add_to(CLI::App& command, const std::string& designs);
  // Nothing if it is not given. Throws InputError.
  std::optional<CoefficientRange> read() const;

 private:
  CLI::Option* given_ = nullptr;
};

// Throws InputError where what is swept cannot be so. Does nothing without a range.
void require_sweep(const std::optional<CoefficientRange>& over, const UncertaintyOptions& evaluated,
                   bool draws);

}  // namespace reeve::cli
