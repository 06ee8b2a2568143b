// How a file of readings is to be read, where it does not say so itself.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "cli/outputs.hpp"
#include "readings/measured_data.hpp"

namespace reeve::cli {

struct ReadingFlags {
  // With `data`: they need that option.
  void add_to(CLI::App& command, CLI::Option* data = nullptr);
  // Adds the options for the meaning of columns and their units, also for the log of a rig.
  void add_columns_to(CLI::App& command, CLI::Option* data = nullptr);
  void add_noise_to(CLI::App& command);
  // Throws InputError.
  MeasuredData read(const std::string& file, const Catalogue& catalogue) const;
  ReadingOptions options() const;

 private:
  std::vector<std::string> map_;
  std::vector<std::string> units_;
  std::vector<std::string> noise_;
  std::vector<std::string> exact_;
  TextOption group_;
};

}  // namespace reeve::cli
