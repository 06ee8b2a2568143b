#include <fmt/format.h>

#include <iostream>
#include <string>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/generator_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "reports/exploration/part_words.hpp"
#include "search/enumerate/counting.hpp"
#include "search/limits/limited_counts.hpp"

namespace reeve::cli {
namespace {

struct CountFlags {
  GeneratorFlags generator;
  std::vector<std::string> constraints;
  FormatOption format;
};

CountReport counted(const CountFlags& flags) {
  const AskedParts asked = flags.generator.read();
  const GeneratorOptions& options = asked.generator;
  CountReport report{options.parts, asked.left_out, {}, read_constraints(flags.constraints), {}};
  report.counts = for_option(fmt::format("--fingers {}", options.fingers), [&] {
    return count_routings(options.parts, options.fingers, options.identity);
  });
  if (report.constraints.empty()) return report;
  if (options.identity == FingerIdentity::distinct) {
    throw InputError("--constraint is counted without --distinct-fingers");
  }
  if (options.parts.motors > 1) throw InputError("--constraint is counted for one motor");
  if (!options.parts.beside.empty()) {
    throw InputError("--constraint is counted without --beside-ends");
  }
  report.limited = for_name("--", [&] { return count_limited(options, report.constraints); });
  return report;
}

int run(const CountFlags& flags, const CLI::App&) {
  const CountReport report = counted(flags);
  std::cout << (flags.format.is("json") ? count_json(report)
                                        : printed(count_sheet(report), flags.format));
  return done;
}

void add_options(CLI::App& command, CountFlags& flags) {
  flags.generator.add_to(command, false);
  command
      .add_option("--constraint", flags.constraints,
                  "Also count those that meet this constraint on parts, such as 'sheaths<=2'; "
                  "may be repeated")
      ->allow_extra_args(false);
  flags.format.add_to(command, with_tables({"json"}));
}

constexpr Subcommand<CountFlags> count_command{
    "count", "Count the routings of a set of parts, by formula", add_options, run};

}  // namespace

void add_count(CLI::App& program, int& exit_code) { count_command.add_to(program, exit_code); }

CountReport api::count(const Arguments& arguments) {
  return counted(count_command.parsed(arguments).flags());
}

}  // namespace reeve::cli
