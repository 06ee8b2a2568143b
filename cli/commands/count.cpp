#include <fmt/format.h>

#include <iostream>

#include "cli/commands/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "reports/results/count_report.hpp"
#include "search/enumerate/counting.hpp"

namespace reeve::cli {
namespace {

struct CountFlags {
  GeneratorFlags generator;
  FormatOption format;
};

void run(const CountFlags& flags) {
  const GeneratorOptions options = flags.generator.read();
  const RoutingCounts counts = for_option(fmt::format("--fingers {}", options.fingers), [&] {
    return count_routings(options.parts, options.fingers, options.identity);
  });
  std::cout << (flags.format.is("json")
                    ? count_json(counts)
                    : printed(count_sheet(counts, options.parts), flags.format));
}

}  // namespace

void add_count(CLI::App& program, int&) {
  CLI::App* command =
      program.add_subcommand("count", "How many routings a set of parts makes, by formula");
  auto flags = std::make_shared<CountFlags>();
  flags->generator.add_to(*command, false);
  flags->format.add_to(*command, with_tables({"json"}));
  command->callback([flags] { run(*flags); });
}

}  // namespace reeve::cli
