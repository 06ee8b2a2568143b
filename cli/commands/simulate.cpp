#include <fmt/format.h>

#include <array>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "causes/named_effect.hpp"
#include "causes/term.hpp"
#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/experiment_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "reports/output/files.hpp"
#include "reports/output/shell_word.hpp"
#include "reports/simulation_report.hpp"
#include "studies/simulation_study.hpp"

namespace reeve::cli {
namespace {

struct SimulateFlags {
  CLI::App* command = nullptr;
  ExperimentFlags experiment;
  std::vector<std::string> causes;
  std::vector<std::string> settings;
  CLI::Option* cause = nullptr;
  CLI::Option* set = nullptr;
  std::uint64_t seed = 1;
  TextOption out;
  std::size_t power = 0;
  ModelOption model;
  FormatOption format;
};

struct Given {
  const CLI::Option* option = nullptr;
  std::string value;
};

// Returns the given options, in their order.
std::vector<Given> options_in_order(const CLI::App& command) {
  std::vector<Given> given;
  std::map<const CLI::Option*, std::size_t> seen;
  for (const CLI::Option* option : command.parse_order()) {
    given.push_back({option, option->results()[seen[option]++]});
  }
  return given;
}

// But for the file, so that the same data have the same bytes wherever they are written.
std::string command_text(const SimulateFlags& flags) {
  std::string text = "reeve simulate";
  for (const Given& given : options_in_order(*flags.command)) {
    if (given.option == flags.out.option) continue;
    text += " --" + given.option->get_lnames().front() + " " + shell_word(given.value);
  }
  return text;
}

// With words in place of names of the catalogue: seized_contact[TR5,T1-T2], law[gain of a of TR5].
std::string with_words(const std::string& cause, const Catalogue& catalogue) {
  std::string result = cause.substr(0, cause.find('['));
  for (std::size_t begin = result.size(); begin < cause.size();) {
    const std::size_t end = std::min(cause.find_first_of(" ,]", begin + 1), cause.size());
    const CatalogueEntry* entry = catalogue.find_name(cause.substr(begin + 1, end - begin - 1));
    result += entry == nullptr ? cause.substr(begin, end - begin)
                               : cause[begin] + to_word(entry->routing);
    begin = end;
  }
  return result;
}

Setting read_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError({.what = "--set",
                      .value = text,
                      .expected = "a parameter and its value, such as gain=1.08"});
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

// Each --set belongs to the --cause before it.
std::vector<NamedEffect> read_causes(const SimulateFlags& flags, const Catalogue& catalogue) {
  std::vector<NamedEffect> causes;
  for (const Given& given : options_in_order(*flags.command)) {
    if (given.option == flags.cause) causes.push_back({with_words(given.value, catalogue), {}});
    if (given.option != flags.set) continue;
    if (causes.empty()) {
      throw InputError({.what = "--set",
                        .value = given.value,
                        .expected = "a --cause before it, to which it belongs"});
    }
    causes.back().settings.push_back(read_setting(given.value));
  }
  return causes;
}

// Names the option that gives what the cause depends on.
void require_shown(const NamedEffect& cause, const Survey& possible) {
  struct Remedy {
    bool Survey::*has;
    const char* option;
  };
  constexpr std::array remedies{
      Remedy{&Survey::has_speed, "--speed"}, Remedy{&Survey::has_cycle, "--cycles"},
      Remedy{&Survey::has_temperature, "--temperature"},
      Remedy{&Survey::has_both_directions, "--directions pull,release"},
      Remedy{&Survey::sheath_angle_varies, "--sheath-angle with more than one"}};
  const Lack* lacking = lack(cause.name, possible);
  if (lacking == nullptr) return;
  for (const Remedy& remedy : remedies) {
    if (remedy.has != lacking->has) continue;
    throw InputError({.where = fmt::format("--cause '{}'", cause.name),
                      .what = lacking->why,
                      .expected = remedy.option});
  }
}

// A wrong grasp can be hidden once for each grasp recorded.
bool same(const Effect& a, const Effect& b) {
  return effect_name(a) == effect_name(b) && a.subject.recorded == b.subject.recorded;
}

// A law of a site or a direction that the experiment has not is hidden in nothing. One of size 0 is
// as the user wants it.
void require_to_act(const Effect& effect, const Model& model, const ExperimentPlan& plan,
                    std::uint64_t seed) {
  if (causes::term_of(*effect.cause) == nullptr || effect.values.front() == 0) return;
  constexpr AddedNoise none{0, 0, 0};
  Model without = model;
  without.effects.pop_back();
  if (simulate(plan, model, none, seed).tension_N !=
      simulate(plan, without, none, seed).tension_N) {
    return;
  }
  throw InputError({.where = fmt::format("--cause '{}'", effect_name(effect)),
                    .what = "it changes no tension of the experiment",
                    .expected = "a site, grasps and --directions in which it acts"});
}

Model read_model(const SimulateFlags& flags, const ExperimentPlan& plan,
                 const Catalogue& catalogue) {
  Model model = flags.model.read(catalogue).model;
  std::vector<Routing> routings;
  for (const PlannedRouting& planned : plan.routings) routings.push_back(planned.routing);
  require_hardware_to_fit(model.hardware, routings);
  require_values_to_act(model.hardware, routings);
  const Survey possible = survey(plan);
  for (const NamedEffect& cause : read_causes(flags, catalogue)) {
    require_shown(cause, possible);
    const Effect effect =
        for_name("--cause ", [&] { return effect_of(cause, possible, model.hardware); });
    for (const Effect& other : model.effects) {
      if (same(effect, other)) {
        throw InputError(
            {.where = fmt::format("--cause '{}'", cause.name), .what = "it is given twice"});
      }
    }
    add_effect(model, effect);
    require_to_act(effect, model, plan, flags.seed);
  }
  return model;
}

SimulationReport report_of(const SimulateFlags& flags) {
  const Catalogue catalogue = shipped_catalogue();
  SimulationReport report;
  report.plan = flags.experiment.read_plan(catalogue);
  report.noise = flags.experiment.read_noise();
  report.model = read_model(flags, report.plan, catalogue);
  report.seed = flags.seed;
  report.command = command_text(flags);
  return report;
}

SimulationReport simulated(const SimulateFlags& flags) {
  SimulationReport report = report_of(flags);
  report.simulation = simulate(report.plan, report.model, report.noise, report.seed);
  return report;
}

std::optional<PowerReport> power(const SimulateFlags& flags, const StudySupervision& supervision) {
  return power_study(report_of(flags), flags.power, simulation_csv, supervision);
}

int run(const SimulateFlags& flags, const CLI::App&) {
  const bool to_file = flags.out.is_given();
  if (to_file && flags.out.text.empty())
    throw InputError({.what = "-o", .value = "", .expected = "a file"});
  std::vector<InputFile> inputs;
  flags.model.list_in(inputs);
  if (to_file) require_not_an_input(flags.out.text, inputs, "-o");
  if (flags.power > 0) {
    const auto report =
        supervised([&](const StudySupervision& supervision) { return power(flags, supervision); });
    if (!report) throw Interrupted();
    std::cout << (flags.format.is("json") ? power_json(*report)
                                          : printed(power_sheet(*report), flags.format));
    return done;
  }
  const SimulationReport report = simulated(flags);
  if (to_file) write_file(flags.out.text, simulation_csv(report));
  std::cout << (to_file ? simulation_summary(report, flags.out.text) : simulation_csv(report));
  return done;
}

void add_options(CLI::App& command, SimulateFlags& flags) {
  flags.command = &command;
  flags.experiment.add_to(command);
  flags.cause = command
                    .add_option("--cause", flags.causes,
                                "Hidden cause or law, such as wear, sensor_gain[T3] or "
                                "seized_contact[TR5,T1-T2]; may be repeated")
                    ->allow_extra_args(false);
  flags.set = command
                  .add_option("--set", flags.settings,
                              "Parameter of the --cause before it, such as gain=1.08")
                  ->allow_extra_args(false);
  flags.model.add_to(command);
  add_with_default(command, "--seed", flags.seed, "Seed of the conditions and the noise")
      ->check(is_seed);
  flags.out.add(command, "-o,--output", "CSV file (default: standard output)");
  CLI::Option* power =
      command
          .add_option("--power", flags.power,
                      "Simulate and diagnose this many experiments; report how often the hidden "
                      "causes are found")
          ->check(CLI::Range(std::size_t{1}, std::size_t{100000}))
          ->excludes(flags.out.option);
  flags.format.add_to(command, with_tables({"json"}));
  command.get_option("--format")->needs(power);
}

constexpr Subcommand<SimulateFlags> simulate_command{
    "simulate", "Simulate the readings of a planned experiment with hidden causes, as a data file",
    add_options, run};

}  // namespace

void add_simulate(CLI::App& program, int& exit_code) {
  simulate_command.add_to(program, exit_code);
}

SimulationReport api::simulate(const Arguments& arguments) {
  return simulated(simulate_command.parsed(arguments).flags());
}

std::optional<PowerReport> api::power(const Arguments& arguments,
                                      const StudySupervision& supervision) {
  const auto parsed = simulate_command.parsed(arguments);
  return cli::power(parsed.flags(), supervision);
}

}  // namespace reeve::cli
