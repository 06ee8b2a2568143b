#include <iostream>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "reports/check_report.hpp"
#include "studies/catalogue_check.hpp"

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

struct CheckFlags {
  FormatOption format;
  FamilyOption family;
  SvgOption svg;
};

void add_options(CLI::App& command, CheckFlags& flags) {
  flags.family.add(command, "--family", "Only this family: paper, or a folder of catalog/families");
  flags.svg.add(command, "--svg",
                "SVG file with a drawing of TR1 to TR7, in the grasp of their published "
                "numbers");
  flags.format.add_to(command, with_tables({"json"}));
}

CheckReport checked(const CheckFlags& flags, const Catalogue& catalogue) {
  return check_all(catalogue, CatalogueFiles::shipped(), flags.family.read(catalogue));
}

int run(const CheckFlags& flags, const CLI::App&) {
  const Catalogue catalogue = shipped_catalogue();
  const CheckReport report = checked(flags, catalogue);
  flags.svg.require_apart_from({});
  if (flags.svg.is_given()) flags.svg.write(catalogue_document(solve(catalogue)));
  std::cout << (flags.format.is("json") ? check_json(report)
                                        : printed(check_sheet(report), flags.format));
  return report.count(CheckStatus::differs) == 0 ? done : answer_is_no;
}

constexpr Subcommand<CheckFlags> check_command{
    "check", "Recompute the published numbers of the catalogue, and say which differ and why",
    add_options, run};

}  // namespace

void add_check(CLI::App& program, int& exit_code) { check_command.add_to(program, exit_code); }

CheckReport api::check(const Arguments& arguments) {
  const auto parsed = check_command.parsed(arguments);
  return checked(parsed.flags(), shipped_catalogue());
}

}  // namespace reeve::cli
