// Friction and bends of a quick question, which stand in place of those of the hardware.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/value_use.hpp"

namespace reeve::cli {

// Radians of "180deg", "180 °", "3.14rad" or "3.14". Throws InputError.
double parse_angle(const std::string& text);

class FrictionFlags {
 public:
  void add_to(CLI::App& command);
  bool is_given() const;
  // A model says itself how large friction is.
  void exclude(CLI::Option& model);
  // Keeps the coefficients that the hardware has for one finger or contact. Throws InputError that
  // names the options.
  void apply(Hardware& hardware) const;
  // Throws InputError on an option whose value no contact takes. If some have values of their own,
  // says so in the name of the hardware's origin.
  void require_to_act(Hardware& hardware, const LookAtNetworks& look) const;

 private:
  std::string given() const;

  std::optional<double> mu_;
  std::optional<double> tube_mu_;
  std::optional<double> sheath_mu_;
  std::optional<std::string> sheath_bend_;
  std::vector<CLI::Option*> options_;
};

}  // namespace reeve::cli
