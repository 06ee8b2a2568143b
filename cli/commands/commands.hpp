// One subcommand, one file: each adds itself to the program and, when chosen, sets the exit code.
#pragma once

#include <CLI/CLI.hpp>

#include "numerics/floors.hpp"

namespace reeve::cli {

// Exit codes of the process.
enum ExitCode : int {
  done = 0,
  // A check failed, a log holds no reading, readings are too few to diagnose, a target is out of
  // reach, no design meets the constraints.
  answer_is_no = 1,
  bad_input = 2,
  interrupted = 3,  // or an internal error
};

void add_show(CLI::App& program, int& exit_code);
void add_rank(CLI::App& program, int& exit_code);
void add_explore(CLI::App& program, int& exit_code);
void add_count(CLI::App& program, int& exit_code);
void add_check(CLI::App& program, int& exit_code);
void add_catalogue(CLI::App& program, int& exit_code);
void add_compare(CLI::App& program, int& exit_code);
void add_import(CLI::App& program, int& exit_code);
void add_simulate(CLI::App& program, int& exit_code);
void add_diagnose(CLI::App& program, int& exit_code);
void add_size(CLI::App& program, int& exit_code);
void add_merge(CLI::App& program, int& exit_code);
void add_export(CLI::App& program, int& exit_code);

// Adds all subcommands in the order of the help, for the shell, Python, the man page and the
// completion.
void add_subcommands(CLI::App& program, int& exit_code);

}  // namespace reeve::cli
