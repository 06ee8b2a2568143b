#include "tests/support/planting_mounting.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/reference_walk.hpp"

namespace reeve::testing {
namespace {

using MountingName = std::pair<std::string, std::string>;  // run and routing

struct Mounting {
  std::map<ContactName, double> exponent_factor;
  std::map<std::string, double> gain;  // by segment
};

MountingName mounting_of(const ExperimentRow& row) { return {row.run, row.condition.word}; }

std::vector<ContactName> contacts_of(const std::string& word) {
  std::vector<ContactName> contacts;
  for (const reference::Tendon& tendon : reference::read_tendons(word)) {
    for (std::size_t k = 0; k < tendon.kinds.size(); ++k) contacts.push_back(tendon.sides(k));
  }
  return contacts;
}

std::size_t most_contacts(const Experiment& experiment) {
  std::size_t most = 0;
  for (const ExperimentRow& row : experiment.rows) {
    most = std::max(most, contacts_of(row.condition.word).size());
  }
  return most;
}

Eigen::VectorXd flat(const Readings& readings) {
  std::vector<double> all;
  for (const auto& row : readings) all.insert(all.end(), row.begin(), row.end());
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// How the expected readings change with what `set` makes of each row by a factor of 1 + step.
Eigen::VectorXd change(const Truth& truth, const Experiment& experiment,
                       const std::function<void(ExperimentRow&, double factor)>& set) {
  constexpr double step = 1e-3;
  Experiment moved = experiment;
  for (ExperimentRow& row : moved.rows) set(row, 1 + step);
  return (flat(expected_readings(truth, moved)) - flat(expected_readings(truth, experiment))) /
         step;
}

// tau_k j_k, a column for each. One k stands for a contact of every routing, at that place of its
// walk: mountings of different routings share no readings.
Eigen::MatrixXd changes(const Truth& truth, const Experiment& experiment, const NoiseLevel& noise) {
  std::vector<Eigen::VectorXd> columns;
  for (std::size_t k = 0; k < most_contacts(experiment); ++k) {
    columns.push_back(noise.mounted_exponent *
                      change(truth, experiment, [k](ExperimentRow& row, double factor) {
                        const auto contacts = contacts_of(row.condition.word);
                        if (k < contacts.size())
                          row.condition.exponent_factor[contacts[k]] = factor;
                      }));
  }
  for (const std::string& channel : experiment.channels) {
    columns.push_back(noise.mounted_gain *
                      change(truth, experiment, [&](ExperimentRow& row, double factor) {
                        row.gain[channel] = factor;
                      }));
  }
  Eigen::MatrixXd all(columns.front().size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = columns[k];
  return all;
}

std::map<MountingName, std::vector<Eigen::Index>> cells_by_mounting(const Experiment& experiment) {
  std::map<MountingName, std::vector<Eigen::Index>> cells;
  Eigen::Index next = 0;
  for (const ExperimentRow& row : experiment.rows) {
    for (std::size_t i = 0; i < row.measured.size(); ++i) cells[mounting_of(row)].push_back(next++);
  }
  return cells;
}

}  // namespace

bool differs_by_mounting(const NoiseLevel& noise) {
  return noise.mounted_exponent != 0 || noise.mounted_gain != 0;
}

Experiment mounted(const Experiment& experiment, const NoiseLevel& noise, std::uint64_t seed) {
  if (!differs_by_mounting(noise)) return experiment;
  NoiseSource source({.relative = 0, .absolute_N = 1, .below_zero = true}, seed);
  const auto standard_normal = [&] { return source.reading(0); };
  std::map<MountingName, Mounting> drawn;
  Experiment result = experiment;
  for (ExperimentRow& row : result.rows) {
    const auto [found, is_new] = drawn.try_emplace(mounting_of(row));
    Mounting& mounting = found->second;
    if (is_new) {
      for (const ContactName& name : contacts_of(row.condition.word)) {
        mounting.exponent_factor[name] =
            std::max(0.0, 1 + noise.mounted_exponent * standard_normal());
      }
      for (const std::string& channel : experiment.channels) {
        mounting.gain[channel] = 1 + noise.mounted_gain * standard_normal();
      }
    }
    row.condition.exponent_factor = mounting.exponent_factor;
    row.gain = mounting.gain;
  }
  return result;
}

std::vector<MountedScatter> mounted_scatter(const Truth& truth, const Experiment& experiment,
                                            const NoiseLevel& noise) {
  const Eigen::VectorXd expected = flat(expected_readings(truth, experiment));
  const Eigen::MatrixXd shared = changes(truth, experiment, noise);
  std::vector<MountedScatter> scatter;
  for (auto& [mounting, cells] : cells_by_mounting(experiment)) {
    const Eigen::MatrixXd own = shared(cells, Eigen::all);
    Eigen::MatrixXd covariance = own * own.transpose();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      covariance(at, at) += std::pow(standard_deviation(noise, expected[cells[i]]), 2);
    }
    scatter.push_back({cells, std::move(covariance)});
  }
  return scatter;
}

Readings beyond_first_order(const Truth& truth, const Experiment& experiment,
                            const Experiment& mounted) {
  const Readings plain = expected_readings(truth, experiment);
  Readings beyond = expected_readings(truth, mounted);
  for (std::size_t r = 0; r < beyond.size(); ++r) {
    for (std::size_t i = 0; i < beyond[r].size(); ++i) beyond[r][i] -= plain[r][i];
  }
  const auto take = [&](const std::function<double&(ExperimentRow&)>& factor_of) {
    constexpr double step = 1e-3;
    Experiment moved = experiment;
    for (ExperimentRow& row : moved.rows) factor_of(row) = 1 + step;
    const Readings there = expected_readings(truth, moved);
    for (std::size_t r = 0; r < beyond.size(); ++r) {
      ExperimentRow row = mounted.rows[r];
      const double off = factor_of(row) - 1;
      for (std::size_t i = 0; i < beyond[r].size(); ++i) {
        beyond[r][i] -= off * (there[r][i] - plain[r][i]) / step;
      }
    }
  };
  double none = 1;
  for (std::size_t k = 0; k < most_contacts(experiment); ++k) {
    take([&](ExperimentRow& row) -> double& {
      const auto contacts = contacts_of(row.condition.word);
      if (k >= contacts.size()) return none = 1;
      return row.condition.exponent_factor.try_emplace(contacts[k], 1).first->second;
    });
  }
  for (const std::string& channel : experiment.channels) {
    take([&](ExperimentRow& row) -> double& {
      return row.gain.try_emplace(channel, 1).first->second;
    });
  }
  return beyond;
}

double mounted_log_likelihood_ratio(const Truth& truth, const Experiment& experiment,
                                    const NoiseLevel& noise, const Readings& other,
                                    const Readings& readings) {
  const Eigen::VectorXd right = flat(readings) - flat(expected_readings(truth, experiment));
  const Eigen::VectorXd wrong = flat(readings) - flat(other);
  double ratio = 0;
  for (const MountedScatter& scatter : mounted_scatter(truth, experiment, noise)) {
    const Eigen::LLT<Eigen::MatrixXd> factor(scatter.covariance);
    const auto distance = [&](const Eigen::VectorXd& off) {
      const Eigen::VectorXd here = off(scatter.cells);
      return here.dot(factor.solve(here));
    };
    ratio += (distance(wrong) - distance(right)) / 2;
  }
  return ratio;
}

}  // namespace reeve::testing
