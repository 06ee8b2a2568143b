#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "pages/pages.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/catalogue_report.hpp"
#include "studies/catalogue_list.hpp"

namespace reeve::cli {
namespace {

struct CatalogueFlags {
  FamilyOption family;
  std::optional<int> fingers;
  OutOption out;
  FormatOption format;
};

void add_options(CLI::App& command, CatalogueFlags& flags) {
  flags.family.add(command, "--family", "Only this family: paper, or a folder of catalog/families");
  command.add_option("--fingers", flags.fingers, "Only mechanisms with this number of fingers")
      ->check(CLI::Range(1, max_fingers));
  flags.out.add_to(command, "index.html with a drawing of each, catalogue.json and figures/");
  flags.format.add_to(command, with_tables({"json"}));
}

std::vector<ListedMechanism> listed(const CatalogueFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  std::vector<ListedMechanism> list = catalogue_list(catalogue, CatalogueFiles::shipped(),
                                                     flags.family.read(catalogue), flags.fingers);
  if (!list.empty()) return list;
  throw InputError({.what = "--fingers",
                    .value = std::to_string(*flags.fingers),
                    .expected = "a number of fingers that something in the catalogue has"});
}

void write_page(const std::filesystem::path& folder, const std::vector<ListedMechanism>& list,
                const CLI::App& command) {
  write_result(folder, catalogue_page(list, command_line(command, {"--format"})),
               {"catalogue.json", catalogue_json(list)});
}

int run(const CatalogueFlags& flags, const CLI::App& command) {
  const std::vector<ListedMechanism> list = listed(flags);
  if (flags.out.is_given()) write_page(flags.out.prepare(), list, command);
  std::cout << (flags.format.is("json") ? catalogue_json(list)
                                        : printed(catalogue_sheet(list), flags.format));
  if (flags.out.is_given()) {
    std::cout << announced("index.html, catalogue.json and figures", flags.out.text, flags.format);
  }
  return done;
}

constexpr Subcommand<CatalogueFlags> catalogue_command{
    "catalogue", "List known routings and mechanisms by name, with their words and drawings",
    add_options, run};

}  // namespace

void add_catalogue(CLI::App& program, int& exit_code) {
  catalogue_command.add_to(program, exit_code);
}

api::ListedCatalogue api::catalogue(const Arguments& arguments) {
  return {listed(catalogue_command.parsed(arguments).flags())};
}

void api::write(const ListedCatalogue& catalogue, const Arguments& arguments) {
  const auto parsed = catalogue_command.parsed(arguments);
  write_page(parsed.flags().out.prepare(), catalogue.mechanisms, parsed.command());
}

}  // namespace reeve::cli
