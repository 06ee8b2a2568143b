#include <fmt/format.h>

#include <atomic>
#include <iostream>
#include <string>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/reading_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "reports/import_report.hpp"
#include "reports/output/files.hpp"
#include "reports/output/shell_word.hpp"
#include "studies/guess_study.hpp"
#include "studies/import_study.hpp"

namespace reeve::cli {
namespace {

struct ImportFlags {
  std::string log;
  ReadingFlags columns;
  ImportLabels labels{.start = "--"};
  SteadyOptions options;
  TextOption direction;
  TextOption out;
  TextOption plot;
  bool guess = false;
  FormatOption format;
};

void require_places(const ImportFlags& flags) {
  std::vector<InputFile> taken{{flags.log, "the data"}};
  flags.out.claim("-o", taken);
  flags.plot.claim("--plot", taken);
  require_svg(flags.plot.text, "--plot");
}

ReadingOptions reading_options(const ImportFlags& flags) {
  ReadingOptions options = flags.columns.options();
  options.guess_option = "--guess";
  if (!flags.labels.routing) options.routing_option = "--routing";
  return options;
}

ImportReport report(const ImportFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  SteadyOptions options = flags.options;
  if (flags.direction.is_given()) {
    options.direction = flags.direction.text == "pull" ? Direction::pull : Direction::release;
  }
  return import_study(read_logged_series(flags.log, reading_options(flags)), flags.labels, options,
                      [&](const std::string& text) { return read_routing(text, catalogue); });
}

// The command that imports the log by the mapping; what nobody has said stands in capitals.
std::string command_by(const GuessReport& result, const CLI::App& command) {
  std::string text = command_line(command, {"--guess", "--map", "--format"});
  for (const ColumnMeaning& mapped : result.guess.map) {
    text += " --map " + shell_word(mapped.column + "=" + mapped.meaning);
  }
  if (result.lacks_routing) text += " --routing ROUTING";
  return text + " -o readings.csv";
}

int guess(const ImportFlags& flags, const CLI::App& command) {
  const Catalogue catalogue = shipped_catalogue();
  const GuessReport result =
      guess_study(flags.log, flags.columns.options(), flags.labels,
                  [&](const std::string& text) { return read_routing(text, catalogue); });
  const std::string next = command_by(result, command);
  std::cout << (flags.format.is("json") ? guess_json(result, next)
                                        : printed(guess_document(result, next), flags.format));
  return result.can_be_imported() ? done : answer_is_no;
}

void print(const ImportReport& result, const ImportFlags& flags, bool written) {
  if (flags.format.is("json")) {
    std::cout << import_json(result);
    return;
  }
  Document document = import_sheet(result);
  if (flags.format.is("table")) {
    Section last;
    if (written) last.lines.push_back({fmt::format("Written: {}", flags.out.text)});
    if (flags.plot.is_given()) {
      last.lines.push_back({fmt::format("Plot: {}", flags.plot.text)});
    }
    document.add(last);
  }
  std::cout << printed(document, flags.format);
}

std::string made_by(const CLI::App& command) {
  return command_line(command, {"--format", "--output", "--plot"});
}

int run(const ImportFlags& flags, const CLI::App& command) {
  const std::atomic<bool>& stop = stop_on_interrupt();
  if (flags.guess) return guess(flags, command);
  require_places(flags);
  const ImportReport result = report(flags);
  if (stop) throw Interrupted();
  const bool found = !result.steady.readings.empty();
  const bool written = found && flags.out.is_given();
  if (flags.plot.is_given()) write_file(flags.plot.text, log_svg(result));
  if (written) write_file(flags.out.text, imported_csv(result, made_by(command)));
  print(result, flags, written);
  return found ? done : answer_is_no;
}

void add_labels(CLI::App& command, ImportFlags& flags) {
  command.add_option("--run", flags.labels.run,
                     "Run of all readings, if the log has no column run (default: 1)");
  command.add_option("--routing", flags.labels.routing,
                     "Routing of all readings, if the log has no column routing: a name of the "
                     "catalogue or a word");
  command.add_option("--held", flags.labels.held,
                     "Held fingers of all readings, such as 1 or '1;2', if the log has no column "
                     "held (default: none)");
  flags.direction
      .add(command, "--direction",
           "Direction of the carriage, if position, speed and load do not show it")
      ->check(one_of({"pull", "release"}));
}

void add_steadiness(CLI::App& command, SteadyOptions& options) {
  add_with_default(command, "--min-duration", options.min_duration_s,
                   "Least duration of a reading in seconds")
      ->check(number_from(0.1, 3600));
  add_with_default(command, "--tolerance", options.tolerance,
                   "Greatest relative change of a steady tension, besides its noise")
      ->check(number_from(0.0001, 0.5));
  add_with_default(command, "--readings-per-stroke", options.readings_per_stroke,
                   "Greatest number of readings of one stroke with a rising or falling load")
      ->check(CLI::Range(std::size_t{1}, std::size_t{20}));
  command.add_flag("--reverse", options.reverse,
                   "Position and speed of the log fall while the carriage pulls");
}

void add_options(CLI::App& command, ImportFlags& flags) {
  command
      .add_option("log", flags.log,
                  "CSV file with a row for each sample; docs/logger.md describes its columns")
      ->check(names_a_file)
      ->required();
  flags.out.add(command, "-o,--output", "CSV file for the readings (default: none written)");
  flags.plot.add(command, "--plot",
                 "SVG file with the signals, the readings, and the samples left out, with reasons");
  command
      .add_flag("--guess", flags.guess,
                "Propose what the columns mean, show the first samples and list what is missing")
      ->excludes(flags.out.option)
      ->excludes(flags.plot.option);
  flags.columns.add_columns_to(command);
  add_labels(command, flags);
  add_steadiness(command, flags.options);
  flags.format.add_to(command, with_tables({"json"}));
}

constexpr Subcommand<ImportFlags> import_command{
    "import", "Find the steady readings in a logger's time series, and write them as a data file",
    add_options, run};

}  // namespace

void add_import(CLI::App& program, int& exit_code) { import_command.add_to(program, exit_code); }

api::ImportedReadings api::import_log(const Arguments& arguments) {
  const auto parsed = import_command.parsed(arguments);
  return {report(parsed.flags()), made_by(parsed.command())};
}

}  // namespace reeve::cli
