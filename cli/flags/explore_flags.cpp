#include "cli/flags/explore_flags.hpp"

#include <fmt/format.h>

#include <chrono>

#include "cli/command_line.hpp"
#include "cli/hand_inputs.hpp"
#include "cli/printing.hpp"
#include "core/error.hpp"
#include "reports/exploration/store_description.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::cli {
namespace {

void require_fingers(const Hardware& hardware, int fingers) {
  for (const ContactHardware& contact : hardware.contacts) {
    if (highest_finger(contact) <= fingers) continue;
    throw InputError({.where = hardware_place(hardware, "contact." + name_of(contact)),
                      .what = "contact",
                      .value = name_of(contact),
                      .expected = fmt::format("strands of fingers 1 to {}", fingers)});
  }
}

// The bends of the sheaths are varied if the hardware file varies nothing: half to twice.
std::vector<VariedRange> usual_ranges(const Hardware& hardware) {
  const double angle = hardware.sheath.angle_rad;
  if (angle == 0) return {};
  return {varied_range("sheath_angle", {angle / 2, 2 * angle}, "by default")};
}

}  // namespace

ParsedExplore::ParsedExplore(const std::vector<std::string>& arguments, const std::string& place) {
  flags.add_to(command);
  try {
    parse(command, arguments);
  } catch (const CLI::ParseError& error) {
    throw InputError({.where = place, .what = error.what()});
  }
}

void StoreFlags::add_to(CLI::App& command) {
  constexpr int a_day = 86400;
  file_.add(command, "--store",
            "SQLite file that keeps the exploration, and from which it continues; see "
            "docs/store.md");
  add_with_default(command, "--store-every", seconds_,
                   "Seconds between two writes of the store; 0: after every batch")
      ->needs(file_.option)
      ->check(CLI::Range(0, a_day));
  keep_
      .add(
          command, "--keep",
          "Designs in the store: best (those that are listed), or all, which rank --store can rank "
          "anew")
      ->needs(file_.option)
      ->check(one_of({"best", "all"}));
}

void StoreFlags::open(std::optional<ExplorationStore>& store, const ExploreReport& planned,
                      const std::vector<std::string>& arguments) const {
  std::optional<Keep> keep;
  if (keep_.is_given()) keep = keep_.text == "all" ? Keep::all : Keep::best;
  for_option("--store", [&] {
    store.emplace(file_.text, store_description(planned, arguments), planned.options.shard, keep);
  });
}

Checkpoint StoreFlags::checkpoint(ExplorationStore& store) const {
  return checkpoint_in(store, std::chrono::seconds(seconds_));
}

namespace {

std::uint64_t routings_of(const GeneratorOptions& options) {
  return RoutingGenerator(options).total();
}

// Each motor pulls something, and few fingers have few ends and joins for them.
InputError too_many_motors(const GeneratorOptions& options) {
  GeneratorOptions fewer = options;
  while (fewer.parts.motors > 1 && routings_of(fewer) == 0) --fewer.parts.motors;
  return InputError({.what = "--motors",
                     .value = std::to_string(options.parts.motors),
                     .expected = fmt::format(
                         "at most {}: with these parts {} finger{} cannot use more",
                         fewer.parts.motors, options.fingers, options.fingers == 1 ? "" : "s")});
}

}  // namespace

ExploreOptions ExploreFlags::read(const Model& with, const Catalogue& catalogue) const {
  ExploreOptions options;
  const AskedParts asked = generator.read(target.is_given());
  options.generator = asked.generator;
  options.left_out = asked.left_out;
  // Says early, before anything is written, if there are too many to count.
  const std::uint64_t routings = for_option(fmt::format("--fingers {}", generator.fingers),
                                            [&] { return routings_of(options.generator); });
  if (routings == 0) throw too_many_motors(options.generator);
  require_fingers(with.hardware, options.generator.fingers);
  require_none_idle(with.hardware, impossible_values(with.hardware, options.generator),
                    "one of the routings that are explored");
  // Letters run in walk order, so that in another routing they are other ends.
  require_no_spools(with.hardware,
                    "none: a spool belongs to an end of one routing (show, rank, size)");
  require_no_springs(with.hardware,
                     "none: a tendon's number belongs to one routing (show, rank, size)");
  require_known_fingers(with.hardware, options.generator.fingers);
  options.shard = for_name("--", [&] { return parse_shard(shard.text); });
  options.keeps_record = shard.is_given();
  options.model = with;
  model.friction().require_to_act(options.model.hardware,
                                  [&](ValueUse& use) { look_at(options.generator, use); });
  options.grasps = ranking.read_grasps(options.generator.fingers, options.generator.parts.motors);
  options.order = ranking.read_order();
  options.score = ranking.read_score();
  require_hand_for("--objectives", options.order.objectives, with.hardware);
  require_hand_for("--score", options.score, with.hardware);
  options.constraints = read_constraints(constraints);
  for (const Constraint& constraint : options.constraints) {
    require_hand_for(fmt::format("--constraint '{}'", constraint.text), {constraint.objective},
                     with.hardware);
  }
  options.prices = tradeoff.read_prices();
  options.tradeoff = tradeoff.read();
  tradeoff.require_prices(options.order, options.score, options.constraints);
  options.top = top;
  options.threads = ranking.threads;
  options.references = known_routings(options, catalogue);
  return options;
}

UncertaintyOptions ExploreFlags::read_uncertainty(const ModelFile& file,
                                                  const ExploreOptions& options) const {
  UncertaintyOptions drawn{file.model,      file.uncertainty, options.grasps,
                           options.order,   ranking.draws,    ranking.seed,
                           ranking.threads, options.score,    options.prices};
  drawn.constraints = options.constraints;
  return drawn;
}

std::optional<SizingOptions> ExploreFlags::read_target(const ModelFile& file,
                                                       const ExploreOptions& options) const {
  if (!target.is_given()) return std::nullopt;
  const int fingers = options.generator.fingers;
  SizingOptions sizing;
  sizing.nominal = file.model;
  sizing.ranges = file.uncertainty;
  sizing.grasps = options.grasps;
  sizing.score = options.score;
  sizing.goal = for_name("--", [&] { return parse_target(target.text, fingers); });
  if (!ranking.grasps.is_given()) sizing.target_grasps = parse_grasps("none", fingers);
  read_vary(file.vary, sizing);
  if (sizing.varied.empty()) sizing.varied = usual_ranges(file.model.hardware);
  sizing.robust = false;
  sizing.starts = 2;
  sizing.seed = ranking.seed;
  sizing.threads = ranking.threads;
  return sizing;
}

void ExploreFlags::add_to(CLI::App& command) {
  generator.add_to(command, true);
  ranking.add_to(command);
  tradeoff.add_to(command);
  store.add_to(command);
  sweep.add_to(command, "up to 8 designs");
  command
      .add_option("--constraint", constraints,
                  "Keep only designs that meet this, such as 'sheaths<=2'; may be repeated")
      ->allow_extra_args(false);
  target.add(command, "--target",
             "Find designs nearest to this ratio of pulls, 1=2,others=1; implies "
             "--distinct-fingers");
  shard
      .add(command, "--shard",
           "i/N: only the i-th of N parts of the exploration; reeve merge joins them")
      ->excludes(target.option);
  add_with_default(command, "--top", top,
                   "Number of best designs to list; the Pareto front is always kept")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
  command
      .add_option("--details", details,
                  "Best designs that the page draws in all grasps (default: up to 170 "
                  "schematics)")
      ->check(CLI::Range(std::size_t{0}, std::size_t{100000}));
  add_with_default(command, "--out", out,
                   "Folder for the page (index.html), the tables (CSV), summary.json and "
                   "figures/");
  model.add_with_friction_to(command);
  tables.add_to(command, "the list of the best");
  format.add_to(command, with_tables({"json"}));
}

}  // namespace reeve::cli
