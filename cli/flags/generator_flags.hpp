// Options that say which routings to generate.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "cli/outputs.hpp"
#include "search/enumerate/field_parts.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::cli {

// The parts and fingers that are asked for, and what the default of --parts leaves out.
struct AskedParts {
  GeneratorOptions generator;
  std::optional<LeftOutParts> left_out;
};

struct GeneratorFlags {
  int fingers = 2;
  std::string parts = "field";
  TextOption tips;
  TextOption joins;
  TextOption ends;
  bool anchored = false;
  int blocks = 0;
  int motors = 1;
  std::string beside;
  PartSet switches;  // only what part_switches has of it
  std::string tendons = "any";
  bool distinct = false;

  void add_to(CLI::App& command, bool with_tendons);
  // `tells_apart` tells the fingers apart, whatever the options say. Throws InputError, also if
  // there are too many routings to count.
  AskedParts read(bool tells_apart = false) const;

 private:
  GeneratorOptions read_parts() const;
  AskedParts read_whole(bool tells_apart) const;

  CLI::Option* parts_ = nullptr;
  CLI::Option* blocks_ = nullptr;
};

}  // namespace reeve::cli
