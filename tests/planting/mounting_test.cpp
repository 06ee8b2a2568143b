#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/planting_mounting.hpp"

namespace reeve::testing {
namespace {

const std::vector<std::string> strands{"T1", "T2"};

// Of M-1-F, pulled with 20 N.
ExperimentRow row_of(const std::string& run) {
  Condition condition;
  condition.word = "M-1-F";
  condition.motor_tension_N = 20;
  return {run, condition, strands, {}};
}

Experiment rows_of(const std::vector<std::string>& runs) {
  Experiment experiment{strands, {}};
  for (const std::string& run : runs) experiment.rows.push_back(row_of(run));
  return experiment;
}

NoiseLevel mountings_of(double exponent, double gain) {
  NoiseLevel noise{0.005, 0.01};
  noise.mounted_exponent = exponent;
  noise.mounted_gain = gain;
  return noise;
}

// By the capstan law, with factors on exponents and gains.
std::vector<double> closed_form(double sheath, double tube, double gain_1, double gain_2) {
  constexpr double tube_phi = 0.18 * std::numbers::pi;
  const double first_N = 20 * std::exp(-sheath * 2 * tube_phi);
  return {gain_1 * first_N, gain_2 * first_N * std::exp(-tube * tube_phi)};
}

std::pair<double, double> mean_and_deviation(const std::vector<double>& values) {
  double sum = 0;
  double squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values) squares += std::pow(value - mean, 2);
  return {mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

TEST(PlantedMounting, LeavesTheExperimentAsItIsWhereMountingsDoNotDiffer) {
  const Experiment same = mounted(rows_of({"A", "B"}), low_noise, 3);
  for (const ExperimentRow& row : same.rows) {
    EXPECT_TRUE(row.condition.exponent_factor.empty());
    EXPECT_TRUE(row.gain.empty());
  }
}

TEST(PlantedMounting, IsOneForTheRowsOfARunAndARoutingAndAnotherForEachOther) {
  Experiment experiment = rows_of({"A", "A", "B", "A"});
  experiment.rows[3].condition.word = "M-1-M";
  const Experiment once = mounted(experiment, mountings_of(0.05, 0.01), 3);
  const auto factors = [&](std::size_t row) { return once.rows[row].condition.exponent_factor; };
  EXPECT_EQ(factors(0), factors(1));
  EXPECT_EQ(once.rows[0].gain, once.rows[1].gain);
  for (const std::size_t other : {2U, 3U}) {
    EXPECT_NE(factors(0).at({"a", "T1"}), factors(other).at({"a", "T1"}));
    EXPECT_NE(once.rows[0].gain, once.rows[other].gain);
  }
  EXPECT_NE(factors(0).at({"a", "T1"}), factors(0).at({"T1", "T2"}));
  const Experiment again = mounted(experiment, mountings_of(0.05, 0.01), 3);
  EXPECT_EQ(again.rows[2].condition.exponent_factor, factors(2));
  EXPECT_NE(mounted(experiment, mountings_of(0.05, 0.01), 4).rows[2].gain, once.rows[2].gain);
}

TEST(PlantedMounting, DrawsExponentsAndGainsAboutTheNominalAsFarAsTheNoiseSays) {
  std::vector<std::string> runs;
  for (int i = 0; i < 20000; ++i) runs.push_back(std::to_string(i));
  std::map<std::string, std::vector<double>> drawn;
  for (const ExperimentRow& row : mounted(rows_of(runs), mountings_of(0.08, 0.01), 5).rows) {
    for (const auto& [name, factor] : row.condition.exponent_factor) {
      drawn[name.first + "-" + name.second].push_back(factor);
    }
    for (const auto& [channel, gain] : row.gain) drawn[channel].push_back(gain);
  }
  ASSERT_EQ(drawn.size(), 4U);
  for (const auto& [name, values] : drawn) {
    const double promised = strands[0] == name || strands[1] == name ? 0.01 : 0.08;
    const auto [mean, deviation] = mean_and_deviation(values);
    EXPECT_NEAR(mean, 1, 0.03 * promised) << name;
    EXPECT_NEAR(deviation, promised, 0.03 * promised) << name;
  }
}

TEST(PlantedMounting, ReadingsFollowTheCapstanLawOfTheMountedExponentsAndGains) {
  Experiment experiment = rows_of({"A"});
  experiment.rows[0].condition.exponent_factor = {{{"a", "T1"}, 1.1}, {{"T1", "T2"}, 0.7}};
  experiment.rows[0].gain = {{"T1", 1.02}, {"T2", 0.97}};
  const std::vector<double> read = expected_readings({}, experiment)[0];
  const std::vector<double> expected = closed_form(1.1, 0.7, 1.02, 0.97);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(read[i], expected[i], 1e-9);
}

TEST(PlantedMounting, KnowsWhatItDoesBeyondTheFirstOrder) {
  const Experiment plain = rows_of({"A"});
  Experiment other = plain;
  other.rows[0].condition.exponent_factor = {{{"a", "T1"}, 1.3}, {{"T1", "T2"}, 1.2}};
  other.rows[0].gain = {{"T1", 1.02}, {"T2", 0.97}};
  const std::vector<double> nominal = closed_form(1, 1, 1, 1);
  const std::vector<double> exact = closed_form(1.3, 1.2, 1.02, 0.97);
  const double tube = 0.18 * std::numbers::pi;
  const std::vector<double> first{0.02 - 0.3 * 2 * tube, -0.03 - 0.3 * 2 * tube - 0.2 * tube};
  const Readings beyond = beyond_first_order({}, plain, other);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(beyond[0][i], exact[i] - nominal[i] * (1 + first[i]), 1e-3 * nominal[i]);
    EXPECT_GT(std::abs(beyond[0][i]), 4e-2 * nominal[i]);
  }
}

// A name that the tensions do not know would change nothing.
TEST(PlantedMounting, NamesTheContactsAsTheTensionsDo) {
  for (const std::string word :
       {"M-1-T-2-F", "M-1-P-2-M", "1-T-2-P-1", "1-P-2-P-1", "M-1b-B-2-F", "M-1-F+M-2-F"}) {
    Experiment experiment = rows_of({"A"});
    experiment.rows[0].condition.word = word;
    const Experiment drawn = mounted(experiment, mountings_of(0.05, 0), 3);
    std::set<ContactName> named;
    for (const auto& [name, factor] : drawn.rows[0].condition.exponent_factor) named.insert(name);
    std::set<ContactName> expected;
    for (const ReferenceContact& contact :
         reference_tensions(word, {}, ReferenceDirection::pull, nominal_hardware()).contacts) {
      expected.emplace(contact.left, contact.right);
    }
    EXPECT_EQ(named, expected) << word;
  }
}

// The likelihood of the rows of one mounting, integrated over what mountings may be, as a sum over
// a grid of the four standard normal numbers; readings are off by `off_N` beside.
double integrated_likelihood(const std::vector<std::vector<double>>& rows, const NoiseLevel& noise,
                             double off_N) {
  constexpr double most = 6;
  constexpr double step = 0.5;
  const std::vector<double> nominal = closed_form(1, 1, 1, 1);
  const double exponent = noise.mounted_exponent;
  const double gain = noise.mounted_gain;
  double sum = 0;
  for (double a = -most; a <= most; a += step) {
    for (double b = -most; b <= most; b += step) {
      for (double c = -most; c <= most; c += step) {
        for (double d = -most; d <= most; d += step) {
          const std::vector<double> mean =
              closed_form(1 + exponent * a, 1 + exponent * b, 1 + gain * c, 1 + gain * d);
          double squares = a * a + b * b + c * c + d * d;
          for (const std::vector<double>& row : rows) {
            for (std::size_t i = 0; i < row.size(); ++i) {
              squares +=
                  std::pow((row[i] - mean[i] - off_N) / standard_deviation(noise, nominal[i]), 2);
            }
          }
          sum += std::exp(-squares / 2);
        }
      }
    }
  }
  return sum;
}

TEST(PlantedMounting, LikelihoodRatioIsThatOfIntegratingOverAllMountings) {
  const NoiseLevel noise = mountings_of(0.005, 0.004);
  const Experiment experiment = rows_of({"A", "A", "B"});
  const Readings readings{{6.48, 3.65}, {6.44, 3.68}, {6.41, 3.70}};
  constexpr double off_N = 0.1;
  Readings other = expected_readings({}, experiment);
  for (std::vector<double>& row : other) {
    for (double& reading : row) reading += off_N;
  }
  double expected = 0;
  for (const Readings& of_mounting : {Readings{readings[0], readings[1]}, Readings{readings[2]}}) {
    expected += std::log(integrated_likelihood(of_mounting, noise, 0) /
                         integrated_likelihood(of_mounting, noise, off_N));
  }
  const double found = mounted_log_likelihood_ratio({}, experiment, noise, other, readings);
  EXPECT_GT(expected, 3);
  EXPECT_NEAR(found, expected, 0.02 * expected);
}

}  // namespace
}  // namespace reeve::testing
