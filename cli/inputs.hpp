// What several subcommands take: routings by word or name, hardware, formats, and the parts.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/hardware_file.hpp"
#include "search/generator.hpp"
#include "search/objectives.hpp"

namespace reeve::cli {

// A catalogue name or a word. Throws InputError that says what was tried.
Routing read_routing(const std::string& text, const Catalogue& catalogue);
// The same, and every tendon must hang on the motor.
Routing read_actuated_routing(const std::string& text, const Catalogue& catalogue);

Catalogue shipped_catalogue();

struct HardwareOption {
  std::string file;

  void add_to(CLI::App& command);
  HardwareFile read() const;  // the paper's hardware if no file is given
};

struct FormatOption {
  std::string format = "table";

  void add_to(CLI::App& command, const std::vector<std::string>& formats);
  bool is(const std::string& name) const { return format == name; }
};

struct GeneratorFlags {
  int fingers = 2;
  std::string parts = "full";
  std::string tips;
  std::string joins;
  std::string ends;
  std::string tendons = "any";
  bool distinct = false;

  void add_to(CLI::App& command, bool with_tendons);
  GeneratorOptions read() const;

 private:
  CLI::Option* tips_ = nullptr;
  CLI::Option* joins_ = nullptr;
  CLI::Option* ends_ = nullptr;
};

struct RankingFlags {
  std::string grasps = "single";
  std::string objectives = "uniformity,efficiency";
  bool uncertainty = false;
  std::size_t draws = 1000;
  std::uint64_t seed = 1;
  int threads = 0;

  void add_to(CLI::App& command);
};

}  // namespace reeve::cli
