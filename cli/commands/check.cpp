#include "studies/check.hpp"

#include <iostream>
#include <memory>

#include "cli/commands/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "reports/results/catalogue_sheet.hpp"
#include "reports/results/check_report.hpp"

namespace reeve::cli {
namespace {

// Each routing in the grasp of its published numbers, with the paper's hardware.
std::vector<ShownEntry> solve(const Catalogue& catalogue) {
  std::vector<ShownEntry> shown;
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (!is_actuated(entry.routing)) continue;
    ShownEntry solved{entry.name + ": " + entry.word, expand(entry.routing), entry.grasp, {}};
    solved.state = tensions(solved.network, mechanics(solved.network, Hardware{}), entry.grasp);
    shown.push_back(std::move(solved));
  }
  return shown;
}

}  // namespace

void add_check(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand(
      "check",
      "Recompute every published number of the catalogue, and say where and why they differ");
  auto format = std::make_shared<FormatOption>();
  auto family = std::make_shared<FamilyOption>();
  family->add_to(*command, "One family of the catalogue alone: paper, or a folder of families/");
  auto svg = std::make_shared<SvgOption>();
  svg->add_to(
      *command,
      "Also draw the routings of the family paper into this file, in the grasps of their published "
      "numbers");
  format->add_to(*command, with_tables({"json"}));
  command->callback([format, svg, family, &exit_code] {
    const Catalogue catalogue = shipped_catalogue();
    const CheckReport report =
        check_all(catalogue, CatalogueFiles::shipped(), family->read(catalogue));
    if (svg->is_given()) svg->write(catalogue_sheet(solve(catalogue)));
    std::cout << (format->is("json") ? check_json(report) : printed(check_sheet(report), *format));
    exit_code = report.count(CheckStatus::differs) == 0 ? done : answer_is_no;
  });
}

}  // namespace reeve::cli
