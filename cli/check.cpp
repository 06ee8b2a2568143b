#include "catalog/check.hpp"

#include <iostream>
#include <memory>

#include "cli/commands.hpp"
#include "cli/inputs.hpp"
#include "reports/check_report.hpp"

namespace reeve::cli {

void add_check(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand(
      "check",
      "Recompute every published number of the catalogue, and say where and why they differ");
  auto format = std::make_shared<FormatOption>();
  format->add_to(*command, {"table", "json"});
  command->callback([format, &exit_code] {
    const CheckReport report = check(shipped_catalogue());
    std::cout << (format->is("json") ? check_json(report) : check_table(report));
    exit_code = report.count(CheckStatus::differs) == 0 ? done : answer_is_no;
  });
}

}  // namespace reeve::cli
