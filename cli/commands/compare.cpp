#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/reading_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/compare_report.hpp"
#include "reports/output/files.hpp"
#include "studies/comparison_study.hpp"

namespace reeve::cli {
namespace {

struct CompareFlags {
  std::string data;
  OutOption out;
  ReadingFlags readings;
  ModelOption model;
  FormatOption format;
};

CompareReport report(const CompareFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  const Model model = flags.model.read(catalogue).model;
  MeasuredData data = flags.readings.read(flags.data, catalogue);
  std::vector<Routing> routings;
  for (const MeasuredRouting& measured : data.routings) routings.push_back(measured.routing);
  require_hardware_to_fit(model.hardware, routings);
  require_values_to_act(model.hardware, routings);
  return comparison_study(std::move(data), model, catalogue);
}

std::vector<InputFile> inputs(const CompareFlags& flags) {
  std::vector<InputFile> inputs{{flags.data, "the data"}};
  flags.model.list_in(inputs);
  return inputs;
}

void write_files(const CompareReport& report, const CompareFlags& flags) {
  const std::filesystem::path folder = flags.out.text;
  flags.out.require_apart_from(inputs(flags));
  prepare_directory(folder, "--out");
  const std::string json = compare_json(report);
  write_result(folder,
               {{{"residuals.csv", residuals_csv(report)}}, {}, {{"comparison.json", json}}},
               result_stamp(json));
}

int run(const CompareFlags& flags, const CLI::App&) {
  const CompareReport result = report(flags);
  if (flags.out.is_given()) write_files(result, flags);
  std::cout << (flags.format.is("json") ? compare_json(result)
                                        : printed(compare_sheet(result), flags.format));
  return done;
}

void add_options(CLI::App& command, CompareFlags& flags) {
  command
      .add_option("data", flags.data, "CSV file of readings; docs/data.md describes its columns")
      ->check(names_a_file)
      ->required();
  flags.out.add_to(command, "residuals.csv and comparison.json");
  flags.readings.add_to(command);
  flags.model.add_to(command);
  flags.format.add_to(command, with_tables({"json"}));
}

constexpr Subcommand<CompareFlags> compare_command{
    "compare", "Compare measured tensions with the model; nothing is fitted", add_options, run};

}  // namespace

void add_compare(CLI::App& program, int& exit_code) { compare_command.add_to(program, exit_code); }

CompareReport api::compare(const Arguments& arguments) {
  return report(compare_command.parsed(arguments).flags());
}

void api::write(const CompareReport& report, const Arguments& arguments) {
  write_files(report, compare_command.parsed(arguments).flags());
}

}  // namespace reeve::cli
