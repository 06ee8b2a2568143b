#include "tests/support/planting.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/planting_mounting.hpp"
#include "tests/support/planting_readings.hpp"

namespace reeve::testing {
namespace {

// Streams of one seed that must not follow each other.
std::uint64_t noise_seed(std::uint64_t seed) { return seed ^ 0x9e3779b97f4a7c15U; }
std::uint64_t mounting_seed(std::uint64_t seed) { return seed ^ 0xd1b54a32d192ed03U; }

Truth truth_without(const std::vector<PlantedEffect>& effects, std::size_t left_out) {
  Truth truth;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (i != left_out) effects[i].impose(truth);
  }
  return truth;
}

Readings with_noise(const Readings& expected, const NoiseLevel& noise, std::uint64_t seed) {
  NoiseSource source(noise, noise_seed(seed));
  Readings readings = expected;
  for (auto& row : readings) {
    for (double& reading : row) reading = as_printed(source.reading(reading));
  }
  return readings;
}

double log_likelihood_of(const NoiseLevel& noise, const Readings& means, const Readings& readings) {
  double sum = 0;
  for (std::size_t row = 0; row < means.size(); ++row) {
    for (std::size_t i = 0; i < means[row].size(); ++i) {
      sum += log_likelihood(noise, means[row][i], readings[row][i]);
    }
  }
  return sum;
}

std::vector<PlantedCell> cells_of(const Experiment& experiment, const Readings& nominal,
                                  const Readings& expected, const Readings& readings) {
  std::vector<PlantedCell> cells;
  for (std::size_t row = 0; row < experiment.rows.size(); ++row) {
    const auto& measured = experiment.rows[row].measured;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      cells.push_back({row, measured[i], nominal[row][i], expected[row][i], readings[row][i]});
    }
  }
  return cells;
}

void set_beyond(std::vector<PlantedCell>& cells, const Readings& beyond) {
  std::size_t next = 0;
  for (const auto& row : beyond) {
    for (const double value : row) cells[next++].beyond_N = value;
  }
}

template <typename Distance>
double root_mean_square(const std::vector<PlantedCell>& cells, Distance distance) {
  double sum = 0;
  for (const PlantedCell& cell : cells) sum += distance(cell) * distance(cell);
  return std::sqrt(sum / static_cast<double>(cells.size()));
}

bool needs_another_experiment(const std::vector<PlantedEffect>& effects) {
  std::set<std::string> names;
  for (const PlantedEffect& effect : effects) names.insert(effect.name);
  return names.size() < effects.size();
}

bool is_seized(const Truth& truth, const std::string& word) {
  const auto& seized = truth.nature.seized;
  return std::any_of(seized.begin(), seized.end(),
                     [&](const SeizedContact& contact) { return contact.word == word; });
}

// The truth, and without each of its effects, by which their visibility is judged.
std::vector<Truth> truths_of(const std::vector<PlantedEffect>& effects) {
  std::vector<Truth> truths;
  for (std::size_t i = 0; i <= effects.size(); ++i) truths.push_back(truth_without(effects, i));
  return truths;
}

// Nobody would measure what the carriage does not pull tight, or what the sensors cannot tell from
// 0; but a seized contact may leave anything slack.
Experiment without_slack_rows(const Experiment& experiment,
                              const std::vector<PlantedEffect>& effects, double least_reading_N) {
  const std::vector<Truth> truths = truths_of(effects);
  const Truth& truth = truths.back();
  Experiment tight;
  for (const ExperimentRow& row : experiment.rows) {
    const bool slack = std::any_of(truths.begin(), truths.end(), [&](const Truth& of) {
      return goes_slack(of.nature, row.condition);
    });
    if (!slack) tight.rows.push_back(row);
  }
  tight.channels = channels_of(tight.rows);
  const Readings readings = expected_readings(truth, tight);
  Experiment kept;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double least = *std::min_element(readings[i].begin(), readings[i].end());
    const ExperimentRow& row = tight.rows[i];
    const bool may_be_0 = is_seized(truth, row.condition.word) || !truth.electronics.dead.empty();
    if (least >= least_reading_N || may_be_0) kept.rows.push_back(row);
  }
  kept.channels = channels_of(kept.rows);
  return kept;
}

}  // namespace

double Planted::rms_to_nominal_N() const {
  return root_mean_square(cells, [](const auto& cell) { return cell.reading_N - cell.nominal_N; });
}

double Planted::rms_to_truth_N() const {
  return root_mean_square(cells, [](const auto& cell) { return cell.reading_N - cell.expected_N; });
}

Planted measure(const Experiment& experiment, const std::vector<PlantedEffect>& effects,
                const NoiseLevel& noise, std::uint64_t seed) {
  const Truth truth = truth_without(effects, effects.size());
  const Readings nominal = expected_readings({}, experiment);
  const Readings expected = expected_readings(truth, experiment);
  const Experiment as_mounted = mounted(experiment, noise, mounting_seed(seed));
  const Readings readings = with_noise(expected_readings(truth, as_mounted), noise, seed);
  const auto ratio_over = [&](const Readings& other) {
    return differs_by_mounting(noise)
               ? mounted_log_likelihood_ratio(truth, experiment, noise, other, readings)
               : log_likelihood_of(noise, expected, readings) -
                     log_likelihood_of(noise, other, readings);
  };
  Planted planted;
  planted.csv = to_csv(experiment, readings, "seed " + std::to_string(seed));
  planted.noise = noise;
  planted.truth = truth;
  planted.log_likelihood_ratio = ratio_over(nominal);
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Readings others =
        effects.size() == 1 ? nominal : expected_readings(truth_without(effects, i), experiment);
    planted.causes.push_back(
        {effects[i].kind, effects[i].name, effects[i].parameters, ratio_over(others)});
  }
  planted.experiment = experiment;
  planted.cells = cells_of(experiment, nominal, expected, readings);
  if (differs_by_mounting(noise)) {
    set_beyond(planted.cells, beyond_first_order(truth, experiment, as_mounted));
  }
  return planted;
}

Planted plant(const PlantingPlan& plan, std::uint64_t seed) {
  Dice dice(seed);
  ExperimentNeeds needs;
  needs.runs = plan.runs;
  needs.least_tension_N = 4 * plan.noise.absolute_N;
  for (const EffectKind kind : plan.effects) add_needs(kind, needs);
  const Experiment experiment = random_experiment(needs, dice);
  std::vector<PlantedEffect> effects;
  do {
    effects.clear();
    for (const EffectKind kind : plan.effects) {
      effects.push_back(draw_effect(kind, plan.size, experiment, dice));
    }
  } while (needs_another_experiment(effects));
  return measure(without_slack_rows(experiment, effects, 3 * plan.noise.absolute_N), effects,
                 plan.noise, seed);
}

std::string with_copied_runs(const Planted& planted, std::size_t copies) {
  Experiment experiment = planted.experiment;
  Readings readings(experiment.rows.size());
  for (const PlantedCell& cell : planted.cells) readings[cell.row].push_back(cell.reading_N);
  std::vector<std::string> runs;
  for (const ExperimentRow& row : planted.experiment.rows) {
    if (runs.empty() || runs.back() != row.run) runs.push_back(row.run);
  }
  for (std::size_t i = 0; i < planted.experiment.rows.size(); ++i) {
    ExperimentRow row = planted.experiment.rows[i];
    const auto run =
        static_cast<std::size_t>(std::find(runs.begin(), runs.end(), row.run) - runs.begin());
    if (run >= copies) continue;
    row.run = runs[(run + 1) % runs.size()] + " again";
    experiment.rows.push_back(row);
    readings.push_back(readings[i]);
  }
  return to_csv(experiment, readings, "with copied rows");
}

}  // namespace reeve::testing
