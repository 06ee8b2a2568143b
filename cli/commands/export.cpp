#include <iostream>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "core/error.hpp"
#include "reports/mujoco/mjcf.hpp"
#include "reports/output/files.hpp"

namespace reeve::cli {
namespace {

struct ExportFlags {
  std::string routing;
  std::string format = "mjcf";
  TextOption out;
  HardwareOption hardware;
};

std::string exported(const ExportFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  const Routing routing = read_actuated_routing(flags.routing, catalogue);
  const Mechanism* mechanism = catalogue.find_mechanism(flags.routing);
  const bool own = mechanism != nullptr && mechanism->hardware && !flags.hardware.is_given();
  const Hardware hardware = own ? *mechanism->hardware : flags.hardware.read().hardware;
  require_hardware_to_fit(hardware, {routing});
  require_known_fingers(hardware, finger_count(routing));
  const std::string source =
      own ? "the mechanism's own, from the catalogue" : flags.hardware.name();
  return mjcf(routing, hardware, {name_of(catalogue, routing), source});
}

int run(const ExportFlags& flags, const CLI::App&) {
  const bool to_file = flags.out.is_given();
  if (to_file && flags.out.text.empty()) {
    throw InputError({.what = "-o", .value = "", .expected = "a file"});
  }
  std::vector<InputFile> inputs;
  flags.hardware.list_in(inputs, "the hardware");
  if (to_file) require_not_an_input(flags.out.text, inputs, "-o");
  const std::string text = exported(flags);
  if (to_file) {
    write_file(flags.out.text, text);
  } else {
    std::cout << text;
  }
  return done;
}

void add_options(CLI::App& command, ExportFlags& flags) {
  command.add_option("routing", flags.routing, "Catalogue name or word")->required();
  add_with_default(command, "--format", flags.format, "mjcf: the XML of MuJoCo")
      ->check(one_of({"mjcf"}));
  flags.out.add(command, "-o,--output", "File (default: standard output)");
  flags.hardware.add_to(command);
}

constexpr Subcommand<ExportFlags> export_command{
    "export",
    "Export one routing as a planar hand for MuJoCo, without friction, which MuJoCo's tendons do not have",
    add_options, run};

}  // namespace

void add_export(CLI::App& program, int& exit_code) { export_command.add_to(program, exit_code); }

}  // namespace reeve::cli
