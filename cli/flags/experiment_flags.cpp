#include "cli/flags/experiment_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/inputs.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "readings/column_name.hpp"

namespace reeve::cli {
namespace {

bool is_number(const std::string& text, Range range, double& number) {
  const auto read = number_in(text);
  if (!read || *read < range.low || *read > range.high) return false;
  number = *read;
  return true;
}

double read_number(const std::string& option, const std::string& text, Range range) {
  double number = 0;
  if (is_number(text, range, number)) return number;
  throw InputError({.what = option,
                    .value = text,
                    .expected = fmt::format("a number from {} to {}", range.low, range.high)});
}

// "5:60" or "5,10,20".
PlannedLevels read_levels(const std::string& option, const std::string& text, Range range) {
  PlannedLevels levels;
  const std::size_t colon = text.find(':');
  const auto read = [&](const std::string& item) {
    double number = 0;
    if (is_number(item, range, number)) return number;
    throw InputError(
        {.where = fmt::format("{} '{}'", option, text),
         .value = item,
         .expected = fmt::format("a range such as 5:60, or a list such as 5,10,20, of numbers from "
                                 "{} to {}",
                                 range.low, range.high)});
  };
  if (colon == std::string::npos) {
    for (const std::string& item : comma_separated(text)) levels.list.push_back(read(item));
    return levels;
  }
  levels.range = {read(text.substr(0, colon)), read(text.substr(colon + 1))};
  if (levels.range.low <= levels.range.high) return levels;
  throw InputError({.what = option, .value = text, .expected = "the lower end of the range first"});
}

bool is_free_name(const std::string& name) {
  const std::optional<ColumnName> known = column_named(name);
  const bool is_known = known && !known->needs_unit && known->role != DataRole::covariate;
  return !name.empty() && !is_known && name != "repeat" && name != "order" && name != "run" &&
         name != "row_in_run";
}

// No file of readings has a column of another name.
void require_readable(const std::string& name, const InputFault& given) {
  try {
    require_short_name(name);
    if (first_not_utf8(name)) throw InputError({.expected = "a name in UTF-8"});
  } catch (const InputError& error) {
    throw error.at(given);
  }
}

// "humidity_pct=20:80"
PlannedColumn read_column(const std::string& option, const std::string& text, bool by_run) {
  constexpr double greatest = 1e12;
  const std::size_t equals = text.find('=');
  PlannedColumn column{std::string(trimmed(std::string_view(text).substr(0, equals))), {}, by_run};
  if (equals == std::string::npos || !is_free_name(column.name)) {
    throw InputError({.what = option,
                      .value = text,
                      .expected = "a name that means nothing else and its values, such as "
                                  "humidity_pct=20:80"});
  }
  require_readable(column.name, {.what = option, .value = text});
  column.levels = read_levels(option, text.substr(equals + 1), {-greatest, greatest});
  return column;
}

std::vector<PlannedColumn> read_columns(const ExperimentFlags& flags) {
  std::vector<PlannedColumn> columns;
  const auto add = [&](const std::string& option, const std::string& text, bool by_run) {
    PlannedColumn column = read_column(option, text, by_run);
    for (const PlannedColumn& other : columns) {
      if (other.name != column.name) continue;
      throw InputError(
          {.where = fmt::format("{} '{}'", option, text), .what = "it is given twice"});
    }
    columns.push_back(std::move(column));
  };
  for (const std::string& text : flags.columns) add("--column", text, false);
  for (const std::string& text : flags.run_columns) add("--run-column", text, true);
  return columns;
}

std::vector<Direction> read_directions(const std::string& text) {
  std::vector<Direction> directions;
  for (const std::string& item : comma_separated(text)) {
    const Direction direction = item == "release" ? Direction::release : Direction::pull;
    const bool known = item == "release" || item == "pull";
    if (!known || std::ranges::count(directions, direction) > 0) {
      throw InputError({.where = fmt::format("--directions '{}'", text),
                        .value = item,
                        .expected = "pull, release, or pull,release"});
    }
    directions.push_back(direction);
  }
  return directions;
}

std::vector<Grasp> read_grasps(const std::string& text, int fingers) {
  if (fingers == 0) return {Grasp{}};
  const bool is_set = text == "single" || text == "all";
  std::vector<Grasp> grasps;
  for (const WeightedGrasp& weighted : parse_grasps(text, fingers)) {
    if (weighted.weight != 1) {
      throw InputError({.where = fmt::format("grasps '{}'", text),
                        .what = "every grasp is measured equally often",
                        .expected = "no weights"});
    }
    const bool nothing_closes = held_fingers(weighted.grasp).size() == std::size_t(fingers);
    if (!(is_set && nothing_closes)) grasps.push_back(weighted.grasp);
  }
  return grasps;
}

std::vector<PlannedRouting> read_routings(const ExperimentFlags& flags,
                                          const Catalogue& catalogue) {
  std::vector<PlannedRouting> routings;
  for (const std::string& text : comma_separated(flags.routings)) {
    const CatalogueEntry* entry = catalogue.find_name(text);
    const Routing routing =
        for_option("--routings", [&] { return read_actuated_routing(text, catalogue); });
    if (const int motors = carriage_count(routing); motors > 1) {
      throw InputError(
          {.where = fmt::format("--routings '{}'", text),
           .what = fmt::format("it has {} motors, and a reading one motor tension", motors),
           .expected = "a routing of one motor"});
    }
    PlannedRouting planned{"", to_word(routing), routing, expand(routing), {}};
    planned.label = entry != nullptr ? entry->name : planned.word;
    for (const PlannedRouting& other : routings) {
      if (other.word == planned.word) {
        throw InputError({.where = fmt::format("--routings '{}'", flags.routings),
                          .what = fmt::format("'{}' is given twice", planned.word)});
      }
    }
    planned.grasps =
        for_name("--", [&] { return read_grasps(flags.grasps, planned.network.fingers); });
    routings.push_back(std::move(planned));
  }
  return routings;
}

// By number within each kind, strands first.
std::vector<Segment> all_channels(const std::vector<PlannedRouting>& routings, bool strands_only) {
  std::vector<Segment> channels;
  const auto key = [](const Segment& s) { return std::pair(s.kind, s.number); };
  for (const PlannedRouting& routing : routings) {
    for (const Segment& segment : routing.network.segments) {
      if (!strands_only || segment.kind == SegmentKind::strand) channels.push_back(segment);
    }
  }
  std::ranges::sort(channels, {}, key);
  channels.erase(std::unique(channels.begin(), channels.end(),
                             [&](const Segment& a, const Segment& b) { return key(a) == key(b); }),
                 channels.end());
  return channels;
}

std::vector<Segment> read_channels(const std::string& text,
                                   const std::vector<PlannedRouting>& routings) {
  if (text == "strands" || text == "all") return all_channels(routings, text == "strands");
  const std::string option = fmt::format("--channels '{}'", text);
  std::vector<Segment> channels;
  for (const std::string& item : comma_separated(text)) {
    const auto segment = segment_named(item);
    if (!segment) {
      throw InputError({.where = option,
                        .value = item,
                        .expected = "strands, all, or a list of segments such as T1,T2,a"});
    }
    channels.push_back(*segment);
    if (std::ranges::count_if(channels, [&](const Segment& s) { return segment_name(s) == item; }) >
        1) {
      throw InputError({.where = option, .what = fmt::format("'{}' is given twice", item)});
    }
  }
  return channels;
}

}  // namespace

void ExperimentFlags::add_to(CLI::App& command) {
  const CLI::Range count(std::size_t{1}, max_planned_readings);
  const auto add = [&](const char* name, auto& value, const char* help) {
    return add_with_default(command, name, value, help);
  };
  const auto add_list = [&](const char* name, std::vector<std::string>& values, const char* help) {
    command.add_option(name, values, help)->allow_extra_args(false);
  };
  command
      .add_option("--routings", routings,
                  "Routings, mounted in turns: catalogue names or words, separated by commas")
      ->required();
  add("--grasps", grasps,
      "Grasps: single (none held, and each finger held alone), all, or held fingers such as "
      "none/1/2");
  add("--directions", directions, "pull, release, or pull,release");
  add("--channels", channels, "Segments with a sensor: strands, all, or names such as T1,T3,a");
  add("--motor-tension", motor_tension, "Motor tensions in N: a range 5:60 or a list 5,10,20");
  speed.add(command, "--speed", "Speeds in mm/s: a range or a list (default: no such column)");
  cycles.add(command, "--cycles",
             "Cycle numbers, rising over the experiment: a range or a list (default: no such "
             "column)");
  temperature.add(command, "--temperature",
                  "Temperatures in C: a range or a list (default: no such column)");
  sheath_angle.add(
      command, "--sheath-angle",
      "Wrap angles of all sheaths in rad: a range or a list (default: the hardware's)");
  add_list("--column", columns,
           "A further column that varies between readings, such as humidity_pct=20:80; may be "
           "repeated");
  add_list("--run-column", run_columns,
           "A further column that varies between runs; may be repeated");
  add("--noise-relative", noise_relative,
      "Standard deviation of a reading, as a share of the tension");
  add("--noise-absolute", noise_absolute,
      "Standard deviation of a reading in N, besides the relative one");
  add("--noise-motor", noise_motor,
      "Standard deviation of the measured motor tension, as a share of the true one");
  add("--runs", runs, "Number of runs; each is a mounting of its own")->check(count);
  add("--rows", rows, "Number of conditions in each run")->check(count);
  add("--repeats", repeats, "Number of readings at each condition")->check(count);
}

ExperimentPlan ExperimentFlags::read_plan(const Catalogue& catalogue) const {
  const auto levels_of = [](const TextOption& levels, Range range) {
    return levels.is_given()
               ? std::optional(read_levels(levels.option->get_name(), levels.text, range))
               : std::nullopt;
  };
  ExperimentPlan plan;
  plan.routings = read_routings(*this, catalogue);
  plan.directions = read_directions(directions);
  plan.channels = read_channels(channels, plan.routings);
  plan.motor_tension_N = read_levels("--motor-tension", motor_tension, {0, 1e6});
  plan.speed_mm_s = levels_of(speed, {1e-3, 1e6});
  plan.cycle = levels_of(cycles, {0, 1e9});
  plan.temperature_C = levels_of(temperature, {-273.15, 1e4});
  plan.sheath_angle_rad = levels_of(sheath_angle, {0, 100});
  plan.columns = read_columns(*this);
  plan.runs = runs;
  plan.rows = rows;
  plan.repeats = repeats;
  for_name("--", [&] { validate(plan); });
  return plan;
}

AddedNoise ExperimentFlags::read_noise() const {
  return {read_number("--noise-relative", noise_relative, {0, 1}),
          read_number("--noise-absolute", noise_absolute, {0, 1000}),
          read_number("--noise-motor", noise_motor, {0, 1})};
}

}  // namespace reeve::cli
