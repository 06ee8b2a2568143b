#include "bench/confusion/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/notation.hpp"
#include "tests/support/planting_effects.hpp"

namespace reeve::bench {
namespace {

using testing::EffectKind;
using testing::EffectSize;
using testing::NoiseLevel;
using testing::Planted;
using testing::PlantingPlan;

const std::array sizes{EffectSize::small, EffectSize::medium, EffectSize::large};
const std::array noises{testing::low_noise, testing::high_noise};

// Distinct seeds for distinct parts and indices.
std::uint64_t mixed(std::uint64_t seed, Part part, std::size_t index) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(part) * 0x632be59bU +
                    (static_cast<std::uint64_t>(index) << 20U);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  return z ^ (z >> 31U);
}

std::vector<EffectKind> kinds_with_parameters() {
  std::vector<EffectKind> kinds = testing::library_effects();
  std::erase(kinds, EffectKind::wrong_grasp);
  std::erase(kinds, EffectKind::seized_contact);
  return kinds;
}

template <typename Item, typename Items>
Item turn(const Items& items, std::size_t& index) {
  const Item item = items[index % items.size()];
  index /= items.size();
  return item;
}

std::vector<EffectKind> two_kinds(std::uint64_t seed) {
  testing::Dice dice(seed);
  std::vector<EffectKind> kinds = testing::library_effects();
  dice.shuffle(kinds);
  return {kinds[0], kinds[1]};
}

Trial trial_of(Part part, std::size_t index, std::uint64_t seed) {
  Trial trial;
  trial.part = part;
  trial.seed = mixed(seed, part, index);
  PlantingPlan& plan = trial.plan;
  switch (part) {
    case Part::single:
      plan.effects = {turn<EffectKind>(testing::library_effects(), index)};
      plan.size = turn<EffectSize>(sizes, index);
      break;
    case Part::rig:
      plan.effects = {turn<EffectKind>(testing::rig_effects(), index)};
      plan.size = index++ % 2 == 0 ? EffectSize::medium : EffectSize::large;
      index /= 2;
      break;
    case Part::coverage:
      plan.effects = {turn<EffectKind>(kinds_with_parameters(), index)};
      plan.size = index++ % 2 == 0 ? EffectSize::medium : EffectSize::large;
      index /= 2;
      break;
    case Part::pairs:
      plan.effects = two_kinds(trial.seed);
      plan.size = index++ % 2 == 0 ? EffectSize::medium : EffectSize::large;
      index /= 2;
      break;
    case Part::unknown:
      plan.effects = {turn<EffectKind>(testing::unknown_effects(), index)};
      plan.size = turn<EffectSize>(sizes, index);
      break;
    case Part::alias:
      trial.alias = turn<testing::AliasKind>(testing::alias_kinds(), index);
      plan.size = EffectSize::large;
      break;
    case Part::leakage:
      if (index % 2 == 1) plan.effects = {turn<EffectKind>(testing::library_effects(), index)};
      break;
    case Part::mounting:
    case Part::heavy:
    case Part::negative:
      if (index % 3 != 2) {
        plan.effects = {testing::Dice(trial.seed).pick(testing::library_effects())};
        plan.size = index % 3 == 0 ? EffectSize::medium : EffectSize::large;
      }
      index /= 3;
      break;
    case Part::dirty:
      trial.dirt = turn<testing::Dirt>(testing::all_dirt(), index);
      if (index % 3 != 2) {
        plan.effects = {testing::Dice(trial.seed).pick(testing::library_effects())};
      }
      index /= 3;
      break;
    case Part::few_mountings:
      plan.runs = turn<int>(std::array{3, 6, 20}, index);
      break;
    case Part::null:
      break;
  }
  plan.noise = turn<NoiseLevel>(noises, index);
  if (part == Part::mounting || part == Part::few_mountings) {
    plan.noise.mounted_exponent = turn<double>(std::array{0.03, 0.05, 0.08}, index);
  }
  if (part == Part::heavy) plan.noise.tail_degrees = 3;
  if (part == Part::negative) {
    plan.noise.below_zero = true;
    plan.noise.absolute_N = 0.5;
  }
  return trial;
}

Finding finding_of(const DiagnosisResult& result) {
  Finding finding{result.verdict, {}, result.indistinguishable, result.not_confirmed};
  for (const NamedCause& cause : result.causes) finding.named.push_back(cause.name);
  return finding;
}

// Parameters are matched by their order, not by what they are called.
std::vector<FoundInterval> intervals_of(const Planted& planted, const DiagnosisResult& result) {
  std::vector<FoundInterval> intervals;
  for (const testing::PlantedCause& hidden : planted.causes) {
    for (const NamedCause& found : result.causes) {
      if (found.name != hidden.name) continue;
      const std::size_t count = std::min(hidden.parameters.size(), found.parameters.size());
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [parameter, truth] = hidden.parameters[i];
        const EstimatedParameter& estimate = found.parameters[i];
        intervals.push_back({std::string(testing::planted_name(hidden.kind)) + "." + parameter,
                             truth, estimate.value, estimate.low, estimate.high});
      }
    }
  }
  const auto planted_too = [&](const std::string& name) {
    return std::any_of(planted.causes.begin(), planted.causes.end(),
                       [&](const testing::PlantedCause& hidden) { return hidden.name == name; });
  };
  for (const CalibratedCoefficient& free : result.calibration) {
    if (planted_too(free.name)) continue;
    intervals.push_back({"calibration of " + free.name, *free.parameter.nominal,
                         free.parameter.value, free.parameter.low, free.parameter.high});
  }
  return intervals;
}

// Computes the possible gain over all readings, as folds leave out each of them once.
double possible_gain(const Planted& planted, const MeasuredData& data,
                     const DiagnosisResult& result) {
  std::map<std::pair<std::size_t, std::string>, const testing::PlantedCell*> cells;
  for (const auto& cell : planted.cells) cells[{cell.row, cell.channel}] = &cell;
  double nominal = 0, truth = 0;
  for (const ComparedCell& compared : result.cells) {
    const auto& cell =
        *cells.at({compared.cell.reading, data.channels[compared.cell.channel].name});
    nominal += std::pow(cell.reading_N - cell.nominal_N, 2);
    truth += std::pow(cell.reading_N - cell.expected_N, 2);
  }
  return 1 - std::sqrt(truth / nominal);
}

double least_ratio(const Planted& planted) {
  double least = planted.log_likelihood_ratio;
  for (const auto& cause : planted.causes) least = std::min(least, cause.log_likelihood_ratio);
  return least;
}

void diagnose_planted(const Planted& planted, const DiagnoseOptions& options, Outcome& outcome) {
  const MeasuredData data = parse_planted(planted.csv);
  const DiagnosisResult result = diagnose(data, {}, options);
  outcome.finding = finding_of(result);
  for (const auto& cause : planted.causes) outcome.planted.push_back(cause.name);
  outcome.oracle = least_ratio(planted);
  outcome.csv = planted.csv;
  if (planted.causes.empty() || names_all(outcome, outcome.finding)) {
    outcome.intervals = intervals_of(planted, result);
  }
  if (names_all(outcome, outcome.finding) && result.held_out) {
    outcome.gain = {result.held_out->reduction, possible_gain(planted, data, result)};
  }
}

void diagnose_alias(const DiagnoseOptions& options, Outcome& outcome) {
  const Trial& trial = outcome.trial;
  const auto alias = testing::plant_alias(trial.alias, trial.plan.noise, trial.seed);
  diagnose_planted(alias.aliased, options, outcome);
  outcome.equivalent.assign(alias.names.begin(), alias.names.end());
  outcome.with_more = finding_of(diagnose(parse_planted(alias.separated.csv), {}, options));
}

void diagnose_copies(const Planted& planted, const DiagnoseOptions& options, Outcome& outcome) {
  const MeasuredData copied = parse_planted(testing::with_copied_runs(planted, 2));
  const DiagnosisResult result = diagnose(copied, {}, options);
  outcome.with_more = finding_of(result);
  outcome.copies_dropped =
      result.dropped_duplicates == copied.readings.size() - planted.experiment.rows.size();
}

bool asks_for_the_right_one(Part part) {
  constexpr std::array parts{Part::single,   Part::rig,   Part::pairs,
                             Part::mounting, Part::heavy, Part::negative};
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

std::vector<std::string> said_equivalent(const Finding& finding, const std::string& name) {
  for (const auto& group : finding.indistinguishable) {
    if (group.front() == name) return group;
  }
  return {name};
}

const char* part_name(Part part) {
  constexpr std::array names{"single",   "null",    "pairs",    "unknown",       "alias",
                             "coverage", "leakage", "mounting", "few_mountings", "heavy",
                             "negative", "rig",     "dirty"};
  return names[static_cast<std::size_t>(part)];
}

const std::vector<Part>& all_parts() {
  static const std::vector<Part> parts{
      Part::single,   Part::null,  Part::pairs,    Part::unknown,       Part::coverage,
      Part::leakage,  Part::alias, Part::mounting, Part::few_mountings, Part::heavy,
      Part::negative, Part::rig,   Part::dirty};
  return parts;
}

std::string Trial::kind() const {
  if (part == Part::alias) return testing::alias_name(alias);
  if (plan.effects.empty()) return "nothing";
  std::string kinds;
  for (const EffectKind kind : plan.effects) {
    kinds += (kinds.empty() ? "" : " + ") + std::string(testing::planted_name(kind));
  }
  return kinds;
}

std::string Trial::column() const {
  const std::string noise = plan.noise.relative < 0.02 ? "1 %" : "3 %";
  if (part == Part::dirty) return testing::dirt_name(dirt);
  const bool sized = !plan.effects.empty();
  std::string text = (sized ? std::string(testing::size_name(plan.size)) + ", " : "") + noise;
  if (plan.noise.mounted_exponent > 0) {
    text += fmt::format(", mountings {:.0f} %", 100 * plan.noise.mounted_exponent);
  }
  if (plan.runs > 0) text += fmt::format(", {} runs", plan.runs);
  return text;
}

std::vector<Trial> trials_of(Part part, std::size_t sets, std::uint64_t seed) {
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < sets; ++i) trials.push_back(trial_of(part, i, seed));
  return trials;
}

bool names_all(const Outcome& outcome, const Finding& finding) {
  const std::set<std::string> hidden(outcome.planted.begin(), outcome.planted.end());
  return finding.verdict == Verdict::cause &&
         hidden == std::set<std::string>(finding.named.begin(), finding.named.end());
}

bool names_among_others(const Outcome& outcome) {
  const Finding& finding = outcome.finding;
  if (finding.verdict != Verdict::indistinguishable || names_wrong(outcome, finding)) return false;
  std::set<std::string> said;
  for (const std::string& name : finding.named) {
    for (const std::string& one : said_equivalent(finding, name)) said.insert(one);
  }
  return outcome.planted.size() <= finding.named.size() &&
         std::all_of(outcome.planted.begin(), outcome.planted.end(),
                     [&](const std::string& hidden) { return said.contains(hidden); });
}

bool names_wrong(const Outcome& outcome, const Finding& finding) {
  const auto is_hidden = [&](const std::string& name) {
    return std::find(outcome.planted.begin(), outcome.planted.end(), name) != outcome.planted.end();
  };
  return std::any_of(finding.named.begin(), finding.named.end(), [&](const std::string& name) {
    const std::vector<std::string> equivalent = said_equivalent(finding, name);
    return std::none_of(equivalent.begin(), equivalent.end(), is_hidden);
  });
}

MeasuredData parse_planted(const std::string& csv) {
  return parse_measured_data(csv, "planted.csv",
                             [](const std::string& word) { return parse_routing(word); });
}

Outcome run(const Trial& trial, const DiagnoseOptions& options) {
  Outcome outcome;
  outcome.trial = trial;
  if (trial.part == Part::alias) {
    diagnose_alias(options, outcome);
    return outcome;
  }
  const Planted planted = testing::plant(trial.plan, trial.seed);
  diagnose_planted(planted, options, outcome);
  if (asks_for_the_right_one(trial.part)) {
    outcome.separability = separability(planted, parse_planted(planted.csv));
  }
  if (trial.part == Part::leakage) diagnose_copies(planted, options, outcome);
  if (trial.part == Part::dirty) {
    const std::string dirty = testing::dirtied(planted.csv, trial.dirt, trial.seed);
    outcome.with_more = finding_of(diagnose(parse_planted(dirty), {}, options));
  }
  return outcome;
}

}  // namespace reeve::bench
