// Inputs of several subcommands: routings by word or name, hardware, models and formats.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/hardware_file.hpp"
#include "catalog/model_file.hpp"
#include "cli/flags/friction_flags.hpp"
#include "cli/outputs.hpp"
#include "core/error.hpp"
#include "search/evaluate/objectives.hpp"
#include "sizing/sizing_problem.hpp"

namespace reeve::cli {

// A catalogue name or a word. Throws InputError that says what was tried.
Routing read_routing(const std::string& text, const Catalogue& catalogue);
// The same, and every tendon must hang on the motor.
Routing read_actuated_routing(const std::string& text, const Catalogue& catalogue);
// Returns the routing that --like and --fingers name, for so many fingers. Throws InputError.
Routing read_like(const std::string& name, int fingers, const Catalogue& catalogue);

// Routings to compare, each once, whichever way its word is walked.
class GivenRoutings {
 public:
  // Throws InputError that names both words.
  void add(const Routing& routing);

 private:
  std::map<std::string, std::string> words_;  // as given, by canonical word
};

Catalogue shipped_catalogue();

// Runs `read`; the option is the place of whatever input error it throws.
template <typename Read>
auto for_option(const std::string& option, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw error.at(option);
  }
}

// Runs `read`, whose errors begin with an option's name that lacks `start`: search says "shard".
template <typename Read>
auto for_name(const std::string& start, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw error.begun_with(start);
  }
}

// Adds an option whose value at first is its default.
template <typename Value>
CLI::Option* add_with_default(CLI::App& command, const std::string& name, Value& value,
                              const std::string& help) {
  return command.add_option(name, value, help)->capture_default_str();
}

// Like CLI::IsMember, and suggests the name that a mistyped one most likely means.
CLI::Validator one_of(std::vector<std::string> names);

// CLI11's own ranges of numbers let NaN pass, and hexadecimal digits.
CLI::Validator number_from(double low, double high);

// A check of CLI11's for seeds: its conversion would take -1 and what is too large for the greatest
// number.
std::string is_seed(const std::string& text);
// A check of CLI11's for files and folders that are read: an error about a file without a name
// would not say whose it is.
std::string names_a_file(const std::string& text);

// --threads, on whose value no result depends.
void add_threads(CLI::App& command, int& threads);

inline constexpr const char* default_hardware_name = "the paper's, by default";

struct HardwareOption : TextOption {
  CLI::Option* add_to(CLI::App& command);
  HardwareFile read() const;  // the paper's hardware if no file is given
  std::string name() const;   // name of its source
};

// Option for a family of the catalogue.
struct FamilyOption : TextOption {
  // Nothing if none is given. Throws InputError on one that there is not.
  std::optional<std::string> read(const Catalogue& catalogue) const;
};

// Drawings are SVG, whatever the file is called: a name that ends in .pdf or .png is refused.
// Throws InputError.
void require_svg(const std::string& file, const std::string& option);

// A drawing besides the result on stdout.
struct SvgOption : TextOption {
  // Throws InputError.
  void require_apart_from(const std::vector<InputFile>& inputs) const;
  void write(const std::string& content) const;
};

// A folder for a page and what lies beside it.
struct OutOption : TextOption {
  CLI::Option* add_to(CLI::App& command, const std::string& files);
  // None of the files that come into the folder, or go, may be an input. Throws InputError.
  void require_apart_from(const std::vector<InputFile>& inputs) const;
  // Made if it is not there. Throws InputError.
  std::filesystem::path prepare() const;
};

// --hardware or --model; the paper's hardware and no effect if neither is given.
struct ModelOption {
  void add_to(CLI::App& command);
  // Adds the same options and those of a quick question.
  void add_with_friction_to(CLI::App& command);
  bool is_given() const { return model_.is_given() || hardware_.is_given(); }
  const FrictionFlags& friction() const { return friction_; }
  // Effects on routings may name those of the catalogue.
  ModelFile read(const Catalogue& catalogue) const;
  void list_in(std::vector<InputFile>& inputs) const;

 private:
  HardwareOption hardware_;
  FrictionFlags friction_;
  TextOption model_;
};

// A spool that the hardware names must be in one of the routings, a tendon in each. Throws
// OutOfRange where its friction is beyond any contact's.
void require_hardware_to_fit(const Hardware& hardware, const std::vector<Routing>& routings);

// Each value of a finger or contact must act in one of the routings: else it is likely a slip of
// the pen in its file. Of a single routing (`show`, `size`, `export`) a note says so instead, for
// its file may be that of the exploration which found it.
void require_values_to_act(const Hardware& hardware, const std::vector<Routing>& routings);
// Throws InputError about the first of these idle values.
void require_none_idle(const Hardware& hardware, const std::vector<std::string>& keys,
                       const std::string& where);

struct FormatOption {
  std::string format = "table";

  void add_to(CLI::App& command, const std::vector<std::string>& formats);
  bool is(const std::string& name) const { return format == name; }
};

// Reads --constraint, each once.
std::vector<Constraint> read_constraints(const std::vector<std::string>& texts);

// Reads the variables that the hardware file varies, and those that it keeps equal. Throws
// InputError.
void read_vary(const VaryTable& table, SizingOptions& options);

}  // namespace reeve::cli
