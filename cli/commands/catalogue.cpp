#include <iostream>
#include <memory>
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
  flags.family.add_to(command, "Only this family: paper, or a folder of catalog/families");
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
  const PageFiles page = catalogue_page(list, command_line(command, {"--format"}));
  const std::string json = catalogue_json(list);
  write_result(folder, {{}, page.figures, {{"index.html", page.html}, {"catalogue.json", json}}},
               result_stamp(json));
}

void run(const CatalogueFlags& flags, const CLI::App& command) {
  const std::vector<ListedMechanism> list = listed(flags);
  std::filesystem::path folder;
  if (flags.out.is_given()) {
    folder = flags.out.prepare();
    write_page(folder, list, command);
  }
  std::cout << (flags.format.is("json") ? catalogue_json(list)
                                        : printed(catalogue_sheet(list), flags.format));
  if (flags.out.is_given()) {
    std::cout << announced("index.html, catalogue.json and figures", folder, flags.format);
  }
}

}  // namespace

void add_catalogue(CLI::App& program, int&) {
  CLI::App* command = program.add_subcommand(
      "catalogue", "List known routings and mechanisms by name, with their words and drawings");
  auto flags = std::make_shared<CatalogueFlags>();
  add_options(*command, *flags);
  command->callback([flags, command] { run(*flags, *command); });
}

api::ListedCatalogue api::catalogue(const Arguments& arguments) {
  return {listed(ParsedCommand<CatalogueFlags>("catalogue", add_options, arguments).flags())};
}

void api::write(const ListedCatalogue& catalogue, const Arguments& arguments) {
  const ParsedCommand<CatalogueFlags> parsed("catalogue", add_options, arguments);
  write_page(parsed.flags().out.prepare(), catalogue.mechanisms, parsed.command());
}

}  // namespace reeve::cli
