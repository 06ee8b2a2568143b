#include "tests/support/planting_mounting.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/planting_walk.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::testing {
namespace {

using ContactName = std::pair<std::string, std::string>;
using MountingName = std::pair<std::string, std::string>;  // run and routing

MountingName mounting_of(const ExperimentRow& row) { return {row.run, row.condition.word}; }

std::vector<ContactName> contacts_of(const std::string& word) {
  std::vector<ContactName> contacts;
  for (const Walk& walk : walks_of(word)) {
    for (std::size_t k = 0; k < walk.links.size(); ++k) {
      contacts.emplace_back(walk.segments[k], walk.segments[(k + 1) % walk.segments.size()]);
    }
  }
  return contacts;
}

double normal_of(Dice& dice) {
  double sum = 0;
  for (int i = 0; i < 12; ++i) sum += dice.real(0, 1);
  return sum - 6;
}

struct MountedSensors {
  std::map<ContactName, double> exponent;
  std::map<std::string, double> gain;
};

// The mounting with one exponent or gain moved by `step`.
Readings moved(const Truth& truth, const Experiment& experiment, std::size_t which, double step) {
  Experiment other = experiment;
  for (ExperimentRow& row : other.rows) {
    const auto contacts = contacts_of(row.condition.word);
    if (which < contacts.size()) {
      row.condition.exponent_factor[contacts[which]] = 1 + step;
    }
  }
  return expected_readings(truth, other);
}

std::vector<double> flat(const Readings& readings) {
  std::vector<double> all;
  for (const auto& row : readings) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace

Experiment mounted(const Experiment& experiment, const NoiseLevel& noise, std::uint64_t seed) {
  if (noise.mounted_exponent == 0 && noise.mounted_gain == 0) return experiment;
  Dice dice(seed);
  std::map<MountingName, MountedSensors> drawn;
  Experiment result = experiment;
  for (ExperimentRow& row : result.rows) {
    const auto [found, is_new] = drawn.try_emplace(mounting_of(row));
    MountedSensors& of = found->second;
    if (is_new) {
      for (const ContactName& name : contacts_of(row.condition.word)) {
        of.exponent[name] = std::max(0.0, 1 + noise.mounted_exponent * normal_of(dice));
      }
      for (const std::string& channel : experiment.channels) {
        of.gain[channel] = 1 + noise.mounted_gain * normal_of(dice);
      }
    }
    row.condition.exponent_factor = of.exponent;
    row.gain = of.gain;
  }
  return result;
}

double mounted_log_likelihood_ratio(const Truth& truth, const Experiment& experiment,
                                    const NoiseLevel& noise, const Readings& other,
                                    const Readings& readings) {
  constexpr double step = 1e-3;
  const Readings expected = expected_readings(truth, experiment);
  const std::vector<double> mean = flat(expected);
  const std::vector<double> wrong = flat(other);
  const std::vector<double> read = flat(readings);
  std::size_t most = 0;
  for (const ExperimentRow& row : experiment.rows) {
    most = std::max(most, contacts_of(row.condition.word).size());
  }
  std::vector<std::vector<double>> change;
  for (std::size_t k = 0; k < most; ++k) {
    change.push_back(flat(moved(truth, experiment, k, step)));
    for (std::size_t i = 0; i < mean.size(); ++i) {
      change.back()[i] = noise.mounted_exponent * (change.back()[i] - mean[i]) / step;
    }
  }
  std::map<MountingName, std::vector<std::size_t>> cells;
  std::vector<std::string> channel;
  for (const ExperimentRow& row : experiment.rows) {
    for (const std::string& measured : row.measured) {
      cells[mounting_of(row)].push_back(channel.size());
      channel.push_back(measured);
    }
  }
  double ratio = 0;
  for (const auto& [mounting, own] : cells) {
    const auto n = static_cast<Eigen::Index>(own.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right(n), off(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t a = own[static_cast<std::size_t>(i)];
      right[i] = read[a] - mean[a];
      off[i] = read[a] - wrong[a];
      covariance(i, i) += std::pow(standard_deviation(noise, mean[a]), 2);
      for (Eigen::Index j = 0; j < n; ++j) {
        const std::size_t b = own[static_cast<std::size_t>(j)];
        for (const auto& of : change) covariance(i, j) += of[a] * of[b];
        if (channel[a] == channel[b]) {
          covariance(i, j) += std::pow(noise.mounted_gain, 2) * mean[a] * mean[b];
        }
      }
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    ratio += (off.dot(factor.solve(off)) - right.dot(factor.solve(right))) / 2;
  }
  return ratio;
}

}  // namespace reeve::testing
