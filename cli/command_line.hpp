// The command that was given, to print where its results are shown: pasted into a shell, in the
// same folder, it gives them again.
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// True if one of these names, "--threads", is the option's.
bool is_among(const std::vector<std::string>& names, const CLI::Option& option);

// "reeve explore --fingers 3 --hardware 'my glove.toml'": what was given, not what it defaults to,
// positionals first. `left_out` names options that the results do not depend on.
std::string command_line(const CLI::App& command, const std::vector<std::string>& left_out = {});

// " --model 'my model.toml'", for another command that takes the same: of these options those that
// were given, each behind a blank.
std::string given_options(const CLI::App& command, const std::vector<std::string>& names);

// Its options, but for those left out, as they can be given to it again.
std::vector<std::string> given_arguments(const CLI::App& command,
                                         const std::vector<std::string>& left_out);

// Has CLI11 read these, first argument first. By itself it takes what follows "--joins=" for the
// value; here that is an empty one. Throws CLI::ParseError.
void parse(CLI::App& command, const std::vector<std::string>& arguments);

// CLI11 reads whole numbers as C does, and more: 010 would be eight, 0x10 sixteen, an empty text
// zero and "true" one. An option of a whole number takes decimal digits only.
void require_whole_numbers(CLI::App& program);

// The arguments of `command`, one of the program's, as a caller of api.hpp gives them. Throws
// api::OptionError in CLI11's words.
void parse_for_api(CLI::App& program, const CLI::App& command,
                   const std::vector<std::string>& arguments);

// A subcommand's options, parsed from what a caller gives in a shell's place.
template <typename Flags>
class ParsedCommand {
 public:
  ParsedCommand(const std::string& name, void (*add_options)(CLI::App&, Flags&),
                const std::vector<std::string>& arguments)
      : command_(*program_.add_subcommand(name)) {
    add_options(command_, flags_);
    parse_for_api(program_, command_, arguments);
  }
  ParsedCommand(const ParsedCommand&) = delete;
  ParsedCommand& operator=(const ParsedCommand&) = delete;

  const CLI::App& command() const { return command_; }
  const Flags& flags() const { return flags_; }

 private:
  CLI::App program_{"", "reeve"};
  CLI::App& command_;
  Flags flags_;
};

// A subcommand: its name, help and options, and the work that gives the exit code.
template <typename Flags>
struct Subcommand {
  const char* name;
  const char* help;
  void (*add_options)(CLI::App&, Flags&);
  int (*run)(const Flags&, const CLI::App&);

  void add_to(CLI::App& program, int& exit_code) const {
    CLI::App* command = program.add_subcommand(name, help);
    auto flags = std::make_shared<Flags>();
    add_options(*command, *flags);
    command->callback(
        [run = run, flags, command, &exit_code] { exit_code = run(*flags, *command); });
  }

  ParsedCommand<Flags> parsed(const std::vector<std::string>& arguments) const {
    return {name, add_options, arguments};
  }
};

}  // namespace reeve::cli
