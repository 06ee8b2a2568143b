#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/complaint.hpp"
#include "cli/launched.hpp"
#include "cli/supervision.hpp"
#include "cli/unknown_words.hpp"
#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/version.hpp"
#include "numerics/parallel.hpp"
#include "numerics/processes.hpp"
#include "readings/csv.hpp"
#include "reports/output/files.hpp"
#include "studies/ranks.hpp"

// The program: what is asked on the command line is done, and what goes wrong is said on stderr.
namespace reeve::cli {
namespace {

constexpr const char* description =
    "reeve explores, ranks, checks and diagnoses tendon routings: the ways in which one motor's\n"
    "tendon can be led through the fingers of a soft wearable hand.\n\n"
    "A routing is written as the walk of its tendon, such as M-1-T-2-F or 1-P-2-P-1:\n"
    "  1, 2, …  through that finger (b behind the number: a bearing at the fingertip)\n"
    "  M, F     an end tied to the carriage of the motor, an end fixed at the hand\n"
    "  T, B, P  strands joined by a tube, a pulley with bearing, a movable pulley on the carriage\n"
    "  1x       an end tied at that fingertip\n"
    "  Y1, W1   round a pulley (on the arms of a bar) that floats at the hand; as an end, tied to it\n"
    "  -, +     between tokens, between tendons; a walk back to its first finger is a loop\n"
    "Names of the catalogue, such as TR7, can stand in place of a routing.";

std::string version_text() {
  const Version build = version();
  return fmt::format("reeve {} ({})\nMIT licence, copyright 2026 the reeve authors; no warranty",
                     build.number, build.commit);
}

std::string parse_complaint(const CLI::ParseError& error, const CLI::App& program) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unknown_words(program);
  return pointed_to_help(error.what(), program);
}

// A script that hangs should say why.
void say_what_is_waited_for(const char* file, core::Awaited awaited) {
  const char* const why =
      awaited == core::Awaited::writer ? "nobody has written to yet" : "nobody reads yet";
  std::cerr << "reeve: "
            << shortened(one_line(fmt::format("waiting for '{}': a pipe that {}", file, why)))
            << '\n';
}

int run(int argc, char** argv) {
  CLI::App reeve(description, "reeve");
  int exit_code = done;
  bool answered = false;  // by the help or the version
  const Launch launch = launched();
  reeve.require_subcommand(0, 1);
  reeve.set_version_flag("--version", version_text());
  add_subcommands(reeve, exit_code);
  require_whole_numbers(reeve);
  reeve.parse_complete_callback([&] {
    if (!reeve.got_subcommand("explore")) require_alone(launch);
  });
  core::set_waiting_notice(say_what_is_waited_for);
  end_waits_on(&stop_was_requested());
  reeve.footer(
      "Exit codes: 0 done, 1 a negative answer (no design meets the constraints, a number differs), 2 bad usage or input, 3 interrupted, "
      "standard output cannot be written, not enough memory, or an internal error.");
  try {
    parse(reeve, {argv + 1, argv + argc});
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) {
      return complain(parse_complaint(error, reeve), bad_input);
    }
    if (!follows_another()) reeve.exit(error);
    answered = true;
  }
  if (reeve.get_subcommands().empty() && !answered) {
    return complain("a subcommand is required; see reeve --help", bad_input);
  }
  std::cout.flush();
  if (!std::cout) return complain("standard output cannot be written", interrupted);
  return exit_code;
}

int run_to_last_words(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Unconnected&) {
    throw;
  } catch (const InputError& error) {
    return complain(error, bad_input);
  } catch (const OutOfRange& error) {
    return complain(error.what(), bad_input);
  } catch (const Interrupted& error) {
    return complain(error.what(), interrupted);
  } catch (const WaitInterrupted& error) {
    return complain(error.what(), interrupted);
  } catch (const FollowerFailed& error) {
    return complain(error.what(), interrupted);
  } catch (const NoThreads&) {
    return complain_of_threads();
  } catch (const std::bad_alloc&) {
    return complain_of_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    if (error.code() == std::errc::not_enough_memory) return complain_of_memory();
    return complain(error.what(), bad_input);
  } catch (const std::exception& error) {
    return complain(std::string("internal error: ") + error.what(), interrupted);
  }
}

// Returns the exit code (cli/complaint.hpp).
int program(int argc, char** argv) {
  if (!follows_another()) return run_to_last_words(argc, argv);
  leave_first_word_to_others(this_process());
  try {
    return run_to_last_words(argc, argv);
  } catch (const Unconnected& error) {
    return complain_alone(this_process() + error.what(), interrupted);
  }
}

// Also what runs before main may fail. Here and not in a library: the Python module would end its
// interpreter so.
__attribute__((constructor(101))) void prepare_for_the_worst() {
  catch_termination();
  outlive_full_files();
}

}  // namespace
}  // namespace reeve::cli

int main(int argc, char** argv) { return reeve::cli::program(argc, argv); }
