// The scatter between mountings against the same likelihood written out in one dense matrix.
#include "diagnosis/fit/mounting_scatter.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagnosis/fit/mounted_comparison.hpp"
#include "diagnosis/fit/noise.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"

namespace reeve::testing {
namespace {

using diagnosis::mounted_equations;
using diagnosis::MountedEquations;

// Mountings of several routings that differ by 8 % in the sheaths.
MeasuredData mounted_often() {
  PlantingPlan plan;
  plan.noise.mounted_exponent = 0.08;
  plan.runs = 9;
  return read_data(plant(plan, 11).csv);
}

// T1 = 20 e^{-φ_s (1 + x)} and T2 = T1 e^{-φ_t (1 + y)} by the capstan law; x² deviates by √2.
TEST(MountingModes, OfTwoExponentsAreSecondDerivatives) {
  constexpr double sheath = 0.36 * std::numbers::pi;
  constexpr double tube = 0.18 * std::numbers::pi;
  const Eigen::Array2d at{20 * std::exp(-sheath), 20 * std::exp(-sheath - tube)};
  const MeasuredData data =
      read_data("run,routing,direction,motor_tension_N,T1_N,T2_N\nA,M-1-F,pull,20,6,3\n");
  Workers workers(1);
  const MountingModes modes = mounting_modes(all_of(data), Model{}, workers);
  ASSERT_EQ(modes.pairs.size(), 3U);
  for (const MountingModes::Pair& pair : modes.pairs) {
    Eigen::Array2d expected = pair.first == pair.second ? at / std::numbers::sqrt2 : at;
    for (const Mounted kind : {pair.first, pair.second}) {
      expected *= kind == Mounted::tube ? Eigen::Array2d{0, tube} : Eigen::Array2d{sheath, sheath};
    }
    EXPECT_TRUE(pair.by_shares_N.isApprox(expected.matrix(), 0.02)) << pair.by_shares_N;
  }
}

struct Mountings {
  Mountings()
      : data(mounted_often()),
        all(dataset(data, all_readings(data))),
        at(forecast(all, Model{})),
        modes(mounting_modes(all, Model{}, workers)),
        readings(problem(
            all, 0.02 * at.reading_N + Eigen::VectorXd::Constant(at.reading_N.size(), 0.05))),
        equations(mounted_equations(readings, at, modes)) {}

  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd result = -equations.shared * equations.shared.transpose();
    Eigen::Index first = 0;
    for (const Eigen::MatrixXd& square : equations.squares) {
      result.block(first, first, square.rows(), square.rows()) += square;
      first += square.rows();
    }
    return result;
  }

  Eigen::VectorXd scales(const MountedScatter& scatter) const {
    Eigen::VectorXd tau(equations.along.size());
    for (Eigen::Index i = 0; i < tau.size(); ++i) {
      const Mounted kind = equations.kind[static_cast<std::size_t>(i)];
      tau[i] = scatter[static_cast<std::size_t>(kind)];
    }
    return tau;
  }

  Eigen::MatrixXd covariance(const MountedScatter& scatter) const {
    const Eigen::VectorXd tau = scales(scatter);
    return Eigen::MatrixXd::Identity(tau.size(), tau.size()) +
           tau.asDiagonal() * dense() * tau.asDiagonal();
  }

  // With the gamma density about the assumed scatter.
  double surprise(const MountingScatter& found, const MountedScatter& scatter) const {
    const Eigen::MatrixXd all_of_it = covariance(scatter);
    const Eigen::VectorXd along = scales(scatter).cwiseProduct(equations.along);
    const Eigen::LDLT<Eigen::MatrixXd> factors(all_of_it);
    double result =
        factors.vectorD().array().log().sum() - along.dot(Eigen::VectorXd(factors.solve(along)));
    for (std::size_t k = 0; k < mounted_kinds; ++k) {
      if (!found.present[k]) continue;
      const double times = scatter[k] / assumed_scatter[k];
      result += 2 * times - 2 * std::log(times);
    }
    return result;
  }

  Workers workers{1};
  MeasuredData data;
  Dataset all;
  Forecast at;
  MountingModes modes;
  Problem readings;
  MountedEquations equations;
};

TEST(MountingScatter, IsTheLikeliest) {
  const Mountings rig;
  ASSERT_GT(rig.equations.squares.size(), 1U);
  ASSERT_GT(rig.equations.shared.squaredNorm(), 0);
  const MountingScatter found = mounting_scatter(rig.readings, rig.at, rig.modes, std::nullopt);
  const double least = rig.surprise(found, found.relative);
  EXPECT_NE(found.relative[0], assumed_scatter[0]);
  EXPECT_NE(found.relative[1], assumed_scatter[1]);
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    if (!found.present[k] || found.relative[k] == assumed_scatter[k]) continue;
    for (const double times : {0.8, 0.95, 1.05, 1.25}) {
      MountedScatter other = found.relative;
      other[k] *= times;
      EXPECT_GT(rig.surprise(found, other), least - 1e-4) << k << " times " << times;
    }
  }
}

// A bench each of whose runs has a grasp of its own says nothing of how mountings differ: whatever
// separates the runs may be the grasps.
TEST(MountingScatter, ThatNoDifferenceTellsIsTheAssumedOne) {
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  const char* const grasps[] = {"", "1", "2"};
  for (int run = 0; run < 3; ++run) {
    for (int i = 0; i < 6; ++i) {
      const double load = 10 + 4 * i;
      text += fmt::format("{},M-1-T-2-F,{},{},{},{},{},{}\n", run, grasps[run], load, 0.32 * load,
                          0.18 * load, 0.1 * load, 0.06 * load);
    }
  }
  const MeasuredData data = read_data(text);
  const Dataset all = dataset(data, all_readings(data));
  Workers workers(1);
  const Forecast at = forecast(all, Model{});
  const Problem readings = problem(all, 0.02 * at.reading_N);
  const MountingScatter found =
      mounting_scatter(readings, at, mounting_modes(all, Model{}, workers), std::nullopt);
  EXPECT_EQ(found.mounted_again, 2U);
  for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::gain}) {
    const auto k = static_cast<std::size_t>(kind);
    EXPECT_EQ(found.relative[k], assumed_scatter[k]) << mounted_name(kind);
  }
}

TEST(MountingScatter, CountsHowFarReadingsDetermineEachKind) {
  const Mountings rig;
  const MountingScatter found = mounting_scatter(rig.readings, rig.at, rig.modes, 0.06);
  const Eigen::VectorXd left = rig.covariance(found.relative).inverse().diagonal();
  std::array<double, mounted_kinds> expected{};
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    expected[static_cast<std::size_t>(rig.equations.kind[static_cast<std::size_t>(i)])] +=
        1 - left[i];
  }
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    EXPECT_NEAR(found.told_by[k], expected[k], 1e-8 * (1 + expected[k])) << k;
  }
}

// A seized sheath may be tried on the way: then no reading of that model is above 0.
TEST(NoiseWithinMountings, OfAModelThatPullsNothingIsThatOfTheReadings) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < 24; ++i) {
    const double load = 10 + i;
    text += fmt::format("{},M-1-F,pull,{},{},{}\n", 1 + i % 3, load, 0.3 * load, 0.2 * load);
  }
  const MeasuredData data = read_data(text);
  const Dataset all = dataset(data, all_readings(data));
  Subject sheath;
  sheath.routing = "M-1-F";
  sheath.contact = "a-T1";
  Model model;
  add_effect(model, Effect{find_cause("seized_contact"), sheath, {}});
  ASSERT_EQ(forecast(all, model).reading_N.maxCoeff(), 0);
  Workers workers(1);
  const auto noise = noise_left_within_mountings(all, model, mounting_modes(all, model, workers));
  ASSERT_TRUE(noise);
  EXPECT_TRUE(std::isfinite(noise->absolute_N));
  EXPECT_GT(noise->absolute_N, 1);
}

// Pulled and released, with sensors that scatter by 0.5 % and 0.01 N beside motor tensions that are
// written 2 % off.
std::string with_scattering_motor(std::uint64_t seed) {
  std::string text = "run,routing,held,direction,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t row = 0;
  for (int run = 1; run <= 8; ++run) {
    for (const char* word : {"M-1-T-2-F", "M-1-P-2-M", "1-P-2-P-1"}) {
      const Network network = expand(parse_routing(word));
      for (const int turn : {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}) {
        const Grasp grasp = turn == 0 ? Grasp{} : hold({turn});
        const Direction direction = row % 2 == 0 ? Direction::pull : Direction::release;
        const TensionState state = tensions(network, mechanics(network, {}), grasp, direction);
        const double load = 12 + 7 * static_cast<double>(row % 7);
        text += fmt::format("{},{},{},{},{}", run, word, turn == 0 ? "" : std::to_string(turn),
                            direction == Direction::pull ? "pull" : "release",
                            load * (1 + 0.02 * normal(seed, 0, row)));
        for (int strand = 1; strand <= 4; ++strand) {
          const auto segment = find_segment(network, {SegmentKind::strand, strand, 0}).value();
          const double tension = load * state.tension[segment];
          const auto stream = static_cast<std::uint32_t>(strand);
          text += fmt::format(",{}", tension * (1 + 0.005 * normal(seed, stream, row)) +
                                         0.01 * normal(seed, 10 + stream, row));
        }
        text += "\n";
        ++row;
      }
    }
  }
  return text;
}

TEST(NoiseWithinMountings, HoldsNothingOfMotorTensionsThatScatter) {
  ReadingOptions options;
  options.noise.push_back(parse_column_noise("motor=2%"));
  Workers workers(1);
  double relative = 0;
  double absolute_N = 0;
  constexpr int sets = 6;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const MeasuredData data = read_data(with_scattering_motor(seed), options);
    const Dataset all = dataset(data, all_readings(data));
    const auto noise =
        noise_left_within_mountings(all, Model{}, mounting_modes(all, Model{}, workers));
    ASSERT_TRUE(noise);
    relative += noise->relative / sets;
    absolute_N += noise->absolute_N / sets;
  }
  EXPECT_NEAR(relative, 0.005, 0.0005);
  EXPECT_NEAR(absolute_N, 0.01, 0.002);
}

}  // namespace
}  // namespace reeve::testing
