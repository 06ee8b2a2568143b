// A subcommand's options, parsed from what a caller gives in a shell's place (asked.hpp).
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "cli/asked/asked.hpp"
#include "cli/command_line.hpp"

namespace reeve::cli {

// Throws InputError in CLI11's words.
void parse_asked(CLI::App& program, const CLI::App& command, const Arguments& arguments);

template <typename Flags>
class AskedCommand {
 public:
  AskedCommand(const std::string& name, void (*add_options)(CLI::App&, Flags&),
               const Arguments& arguments)
      : command_(*program_.add_subcommand(name)) {
    add_options(command_, flags_);
    parse_asked(program_, command_, arguments);
  }
  AskedCommand(const AskedCommand&) = delete;
  AskedCommand& operator=(const AskedCommand&) = delete;

  const CLI::App& command() const { return command_; }
  const Flags& flags() const { return flags_; }

 private:
  CLI::App program_{"", "reeve"};
  CLI::App& command_;
  Flags flags_;
};

}  // namespace reeve::cli
