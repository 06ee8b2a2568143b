#include "diagnosis/plan/simulation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "causes/model_solver.hpp"
#include "causes/named_effect.hpp"
#include "core/tension/tension.hpp"
#include "numerics/random.hpp"
#include "tests/support/planned.hpp"

namespace reeve::testing {
namespace {

constexpr AddedNoise no_noise{0, 0};

Model model_with(const ExperimentPlan& plan, const std::vector<NamedEffect>& causes) {
  Model model;
  for (const NamedEffect& cause : causes) {
    add_effect(model, effect_of(cause, survey(plan), model.hardware));
  }
  return model;
}

TEST(Simulation, WithoutNoiseAndCausesReadsThePlainModel) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.directions = {Direction::pull, Direction::release};
  const Simulation simulation = simulate(plan, {}, no_noise, 1);
  ASSERT_EQ(simulation.readings.size(), 240U);
  for (std::size_t i = 0; i < simulation.readings.size(); ++i) {
    const PlannedReading& reading = simulation.readings[i];
    const Network& network = plan.routings[reading.routing].network;
    const TensionState state =
        tensions(network, mechanics(network, {}), reading.grasp, reading.direction);
    for (std::size_t c = 0; c < plan.channels.size(); ++c) {
      const double expected = reading.conditions.motor_tension_N *
                              state.tension[*find_segment(network, plan.channels[c])];
      EXPECT_NEAR(*simulation.tension_N[i][c], expected, 1e-12 * expected);
    }
  }
  EXPECT_EQ(simulation.values, 960U);
  EXPECT_EQ(simulation.clipped, 0U);
}

TEST(Simulation, ReadsWhatTheHiddenCausesMakeOfIt) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.cycle = PlannedLevels{{0, 3000}, {}};
  const Model model = model_with(plan, {{"load_dependent_friction", {{"exponent", "0.15"}}},
                                        {"wear", {{"change", "-0.4"}, {"cycles", "500"}}},
                                        {"wrong_grasp[M-1-P-2-M]", {{"recorded", "none"}}},
                                        {"sensor_gain[T3]", {{"gain", "1.5"}}}});
  const Simulation simulation = simulate(plan, model, no_noise, 3);
  int in_another_grasp = 0;
  for (std::size_t i = 0; i < simulation.readings.size(); ++i) {
    const PlannedReading& reading = simulation.readings[i];
    const PlannedRouting& routing = plan.routings[reading.routing];
    ModelSolver solver(model, model.hardware, routing.word, routing.network);
    const bool wrong = routing.word == "M-1-P-2-M" && reading.grasp == Grasp{};
    in_another_grasp += wrong ? 1 : 0;
    const TensionState& state =
        solver.solve(wrong ? hold({1}) : reading.grasp, reading.direction, reading.conditions);
    for (std::size_t c = 0; c < plan.channels.size(); ++c) {
      const double gain = segment_name(plan.channels[c]) == "T3" ? 1.5 : 1;
      const double expected = gain * reading.conditions.motor_tension_N *
                              state.tension[*find_segment(routing.network, plan.channels[c])];
      EXPECT_NEAR(*simulation.tension_N[i][c], expected, 1e-9 * expected);
    }
  }
  EXPECT_GT(in_another_grasp, 0);
}

// Of the first routing, where all that arrives passes one sheath.
// T_h1 = T_M e^{-phi (1 + a (h - 50))}, and in run 2 the sensor reads b (V - 24) more of it.
TEST(Simulation, HidesLawsOfFurtherColumns) {
  ExperimentPlan plan;
  plan.routings.push_back(planned_routing("M-F"));
  plan.routings[0].grasps = {Grasp{}};
  plan.channels = {parse_segment("h1")};
  plan.columns = {{"humidity_pct", {{20, 80}, {}}}, {"supply_V", {{22, 26}, {}}, true}};
  plan.runs = 3;
  const Model model =
      model_with(plan, {{"law[exponent of sheath, humidity_pct, linear]",
                         {{"a", "0.008"}, {"range", "30:90"}, {"middle", "50"}}},
                        {"law[gain of h1 in run 2, supply_V, linear]", {{"a", "0.03"}}}});
  const Simulation simulation = simulate(plan, model, no_noise, 3);
  for (std::size_t i = 0; i < simulation.readings.size(); ++i) {
    const PlannedReading& reading = simulation.readings[i];
    const double humidity = std::max(30.0, reading.columns[0]);
    const double phi = 0.36 * std::acos(-1) * (1 + 0.008 * (humidity - 50));
    const double gain = reading.run == 1 ? 1 + 0.03 * (reading.columns[1] - 24) : 1;
    const double expected = reading.conditions.motor_tension_N * std::exp(-phi) * gain;
    EXPECT_NEAR(*simulation.tension_N[i][0], expected, 1e-9 * expected) << i;
  }
}

TEST(Simulation, TakesTheTransmissionsLossFromThePullAndBendsTheSheathsAsPlanned) {
  ExperimentPlan plan = plan_of({"M-1-T-2-F"});
  plan.directions = {Direction::pull, Direction::release};
  plan.sheath_angle_rad = PlannedLevels{{0.5, 7}, {}};
  const Model model = model_with(plan, {{"constant_loss", {{"force_N", "2"}}},
                                        {"wrap_free_loss", {{"exponent", "0.3"}}},
                                        {"drift[T1]", {{"drift_N", "-1"}}}});
  const Simulation simulation = simulate(plan, model, no_noise, 3);
  const auto last = static_cast<double>(simulation.readings.size() - 1);
  for (std::size_t i = 0; i < simulation.readings.size(); ++i) {
    const PlannedReading& reading = simulation.readings[i];
    const double sign = reading.direction == Direction::pull ? 1 : -1;
    const double pulled = reading.conditions.motor_tension_N - 2 * sign;
    const double phi = 0.18 * *reading.sheath_angle_rad + 0.3;
    const double drift = -static_cast<double>(i) / last;
    const double expected = std::max(0.0, pulled * std::exp(-sign * phi) + drift);
    EXPECT_NEAR(*simulation.tension_N[i][0], expected, 1e-5 * pulled) << i;
  }
}

TEST(Simulation, LeavesChannelsEmptyThatTheRoutingDoesNotHave) {
  const ExperimentPlan plan = plan_of({"M-1-F", "M-1-P-2-M"});
  const Simulation simulation = simulate(plan, {}, {}, 1);
  for (std::size_t i = 0; i < simulation.readings.size(); ++i) {
    const bool both = simulation.readings[i].routing == 1;
    EXPECT_TRUE(simulation.tension_N[i][0]);
    EXPECT_EQ(simulation.tension_N[i][2].has_value(), both);
  }
}

// Standardised deviations from the readings without noise, of all channels and readings.
struct Statistics {
  std::array<double, 2> moments{};  // mean, variance
  double beyond_two = 0;
  std::size_t count = 0;
};

Statistics statistics(const AddedNoise& noise) {
  ExperimentPlan plan = plan_of(three_routings);
  plan.runs = 120;
  plan.motor_tension_N = {{20, 60}, {}};
  const Simulation quiet = simulate(plan, {}, no_noise, 4);
  const Simulation noisy = simulate(plan, {}, noise, 4);
  EXPECT_EQ(noisy.clipped, 0U);
  Statistics result;
  for (std::size_t i = 0; i < quiet.readings.size(); ++i) {
    for (std::size_t c = 0; c < plan.channels.size(); ++c) {
      const double tension = *quiet.tension_N[i][c];
      const double sigma = std::hypot(noise.relative * tension, noise.absolute_N);
      const double z = (*noisy.tension_N[i][c] - tension) / sigma;
      result.moments[0] += z;
      result.moments[1] += z * z;
      result.beyond_two += std::abs(z) > 2 ? 1 : 0;
      ++result.count;
    }
  }
  return result;
}

TEST(Simulation, HasNoiseOfTheStandardDeviationsAskedFor) {
  for (const AddedNoise& noise :
       {AddedNoise{0.02, 0}, AddedNoise{0, 0.05}, AddedNoise{0.03, 0.04}}) {
    const Statistics found = statistics(noise);
    const auto n = static_cast<double>(found.count);
    const double beyond_two = std::erfc(std::sqrt(2));
    EXPECT_NEAR(found.moments[0] / n, 0, 4 / std::sqrt(n));
    EXPECT_NEAR(found.moments[1] / n, 1, 4 * std::sqrt(2 / n));
    EXPECT_NEAR(found.beyond_two / n, beyond_two, 4 * std::sqrt(beyond_two / n));
  }
}

TEST(Simulation, CountsWhatItHadToClip) {
  const ExperimentPlan plan = plan_of(three_routings);
  const Simulation simulation = simulate(plan, {}, {0, 2}, 1);
  std::size_t zeros = 0;
  for (const auto& tensions : simulation.tension_N) {
    for (const std::optional<double>& tension : tensions) {
      EXPECT_GE(*tension, 0);
      zeros += *tension == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(zeros, 0U);
  EXPECT_EQ(simulation.clipped, zeros);
}

// The diagnosis calibrates itself with noise from the first streams of its seed.
TEST(Simulation, SharesNoNoiseWithReplicatesOfTheSameSeed) {
  const ExperimentPlan plan = plan_of(three_routings);
  const Simulation quiet = simulate(plan, {}, no_noise, 1);
  const Simulation noisy = simulate(plan, {}, {0.01, 0}, 1);
  for (std::uint32_t stream = 0; stream < 1000; ++stream) {
    double product = 0;
    for (std::uint64_t i = 0; i < 960; ++i) {
      const double tension = *quiet.tension_N[i / 4][i % 4];
      product += (*noisy.tension_N[i / 4][i % 4] / tension - 1) / 0.01 * normal(1, stream, i);
    }
    EXPECT_LT(std::abs(product / 960), 5 / std::sqrt(960)) << stream;
  }
}

TEST(Simulation, IsDecidedByTheSeed) {
  const ExperimentPlan plan = plan_of(three_routings);
  EXPECT_EQ(simulate(plan, {}, {}, 7).tension_N, simulate(plan, {}, {}, 7).tension_N);
  EXPECT_NE(simulate(plan, {}, {}, 7).tension_N, simulate(plan, {}, {}, 8).tension_N);
}

}  // namespace
}  // namespace reeve::testing
