#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/tradeoff_flags.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/inputs.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/motor_sides.hpp"
#include "pages/pages.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/show_report.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::cli {
namespace {

struct ShowFlags {
  std::optional<std::string> routing;
  std::optional<std::string> like;
  int fingers = 0;
  std::vector<std::string> held;
  std::string direction = "pull";
  SvgOption svg;
  OutOption out;
  PricesOption prices;
  ModelOption model;
  FormatOption format;
};

GraspSet grasps(const ShowFlags& flags, const Routing& routing) {
  const int fingers = finger_count(routing);
  if (flags.held.empty()) return single_grasps(fingers);
  GraspSet grasps;
  for (const std::string& held : flags.held) {
    const Grasp grasp = for_name("--", [&] {
      return parse_grasp(held, fingers, carriage_count(routing), motor_ends(expand(routing)));
    });
    for (const WeightedGrasp& other : grasps) {
      if (other.grasp == grasp) throw InputError("--held " + held + " is given twice");
    }
    grasps.push_back({grasp, 1});
  }
  return grasps;
}

Routing asked_routing(const ShowFlags& flags, const Catalogue& catalogue) {
  if (flags.like) return read_like(*flags.like, flags.fingers, catalogue);
  if (flags.routing) return read_actuated_routing(*flags.routing, catalogue);
  throw InputError("routing is required, or --like and --fingers; see reeve show --help");
}

ShownRouting report(const ShowFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  const Routing routing = asked_routing(flags, catalogue);
  const std::string& asked_for = flags.like ? *flags.like : *flags.routing;
  const Mechanism* mechanism = catalogue.find_mechanism(asked_for);
  const bool own = mechanism != nullptr && mechanism->hardware && !flags.model.is_given();
  ModelFile file;
  if (own) {
    file.model = Model{*mechanism->hardware};
    const std::string owner =
        fmt::format("the catalogue's {} (show its word for the default)", mechanism->name);
    file.model.hardware.origin = std::make_shared<const HardwareOrigin>(HardwareOrigin{owner, {}});
  } else {
    file = flags.model.read(catalogue);
  }
  Model& model = file.model;
  if (own) flags.model.friction().apply(model.hardware);
  require_hardware_to_fit(model.hardware, {routing});
  require_known_fingers(model.hardware, finger_count(routing));
  const std::vector<Routing> routings{routing};
  flags.model.friction().require_to_act(model.hardware, looks_at(routings));
  const Direction direction = flags.direction == "pull" ? Direction::pull : Direction::release;
  const GraspSet asked = grasps(flags, routing);
  ShownRouting shown =
      shown_routing(routing, model, asked, direction, catalogue, flags.prices.read());
  if (shown.hand) shown.hand->drawn = motor_force(routing, {model, file.uncertainty, asked, {}});
  shown.own_hardware = own;
  shown.by_word = catalogue.find_routing(asked_for) == nullptr;
  // Another mechanism may have the same word.
  if (mechanism != nullptr) shown.name = mechanism->routing == routing ? mechanism->name : "";
  return shown;
}

void require_places(const ShowFlags& flags) {
  std::vector<InputFile> inputs;
  flags.model.list_in(inputs);
  flags.prices.list_in(inputs, "the prices");
  flags.svg.require_apart_from(inputs);
  flags.svg.list_in(inputs, "the file of --svg");
  flags.out.require_apart_from(inputs);
}

std::string dot(const ShowFlags& flags, const ShownRouting& report) {
  if (flags.held.empty()) return to_dot(report.network, report.word);
  const ShownGrasp& shown = report.grasps.front();
  return to_dot(report.network, report.word + ", held " + to_text(shown.grasp), &shown.state);
}

void require_one_grasp_to_draw(const ShowFlags& flags) {
  if (flags.held.size() < 2) return;
  const std::string what = flags.svg.is_given()     ? "--svg"
                           : flags.format.is("dot") ? "--format dot"
                                                    : "";
  if (!what.empty()) {
    throw InputError({.what = what + " draws one grasp", .expected = "--held once at most"});
  }
}

// A graph has no objectives.
void require_cost_to_be_shown(const ShowFlags& flags) {
  if (!flags.format.is("dot") || !flags.prices.is_given() || flags.out.is_given()) return;
  throw InputError({.where = "--cost",
                    .what = "--format dot shows no cost",
                    .expected = "another format, or --out with it for a page",
                    .form = InputForm::unknown});
}

void write_drawing(const ShowFlags& flags, const ShownRouting& report) {
  flags.svg.write(show_svg(report, flags.held.empty() ? nullptr : &report.grasps.front()));
}

void write_page(const std::filesystem::path& folder, const ShownRouting& report,
                const CLI::App& command) {
  write_result(folder, routing_page(report, command_line(command, {"--format", "--svg"})),
               {"routing.json", show_json(report)});
}

int run(const ShowFlags& flags, const CLI::App& command) {
  require_cost_to_be_shown(flags);
  const ShownRouting shown = report(flags);
  require_one_grasp_to_draw(flags);
  require_places(flags);
  if (flags.svg.is_given()) write_drawing(flags, shown);
  if (flags.out.is_given()) write_page(flags.out.prepare(), shown, command);
  if (flags.format.is("json")) {
    std::cout << show_json(shown);
  } else if (flags.format.is("dot")) {
    std::cout << dot(flags, shown);
  } else {
    std::cout << printed(show_document(shown), flags.format);
  }
  if (flags.out.is_given()) {
    std::cout << announced("index.html, routing.json and figures", flags.out.text, flags.format);
  }
  return done;
}

void add_options(CLI::App& command, ShowFlags& flags) {
  CLI::Option* routing = command.add_option("routing", flags.routing, "Catalogue name or word");
  CLI::Option* like =
      command
          .add_option(
              "--like", flags.like,
              "In place of a routing: the catalogue's mechanism of this name, for --fingers")
          ->excludes(routing);
  CLI::Option* fingers =
      command.add_option("--fingers", flags.fingers, "Number of fingers of --like")
          ->check(CLI::Range(1, max_fingers))
          ->needs(like);
  like->needs(fingers);
  command
      .add_option("--held", flags.held,
                  "Held fingers, such as 1,2 or none; may be repeated (default: none, and each "
                  "finger alone)")
      ->allow_extra_args(false);
  add_with_default(command, "--direction", flags.direction, "Direction of the carriage")
      ->check(one_of({"pull", "release"}));
  flags.svg.add(command, "--svg",
                "SVG file with a drawing in the grasp of --held (without --held: parts "
                "alone, no tensions)");
  flags.out.add_to(command, "a page, index.html, with routing.json and figures/");
  flags.prices.add_to(command, "adds what this routing costs");
  flags.model.add_with_friction_to(command);
  flags.format.add_to(command, with_tables({"json", "dot"}));
}

constexpr Subcommand<ShowFlags> show_command{
    "show",
    "Show one routing: tensions, shares, sliding directions and objectives. A mechanism of the catalogue with coefficients of its own is shown with them",
    add_options, run};

}  // namespace

void add_show(CLI::App& program, int& exit_code) { show_command.add_to(program, exit_code); }

ShownRouting api::show(const Arguments& arguments) {
  return report(show_command.parsed(arguments).flags());
}

void api::write(const ShownRouting& report, const Arguments& arguments) {
  const auto parsed = show_command.parsed(arguments);
  require_places(parsed.flags());
  write_page(parsed.flags().out.prepare(), report, parsed.command());
}

}  // namespace reeve::cli
