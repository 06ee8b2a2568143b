#include <fmt/format.h>

#include <iostream>

#include "cli/asked/asked_command.hpp"
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

RoutingCounts counted(const CountFlags& flags) {
  const GeneratorOptions options = flags.generator.read();
  return for_option(fmt::format("--fingers {}", options.fingers), [&] {
    return count_routings(options.parts, options.fingers, options.identity);
  });
}

void run(const CountFlags& flags) {
  const RoutingCounts counts = counted(flags);
  std::cout << (flags.format.is("json")
                    ? count_json(counts)
                    : printed(count_sheet(counts, flags.generator.read().parts), flags.format));
}

void add_options(CLI::App& command, CountFlags& flags) {
  flags.generator.add_to(command, false);
  flags.format.add_to(command, with_tables({"json"}));
}

}  // namespace

void add_count(CLI::App& program, int&) {
  CLI::App* command =
      program.add_subcommand("count", "How many routings a set of parts makes, by formula");
  auto flags = std::make_shared<CountFlags>();
  add_options(*command, *flags);
  command->callback([flags] { run(*flags); });
}

RoutingCounts asked_count(const Arguments& arguments) {
  return counted(AskedCommand<CountFlags>("count", add_options, arguments).flags());
}

}  // namespace reeve::cli
