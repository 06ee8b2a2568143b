#include "diagnosis/verdict/without_apart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "causes/library.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

constexpr double factor = 0.7;

// Six rows as the model says, and in one grasp one channel that reads 0.7 of it.
std::string readings(std::size_t odd_channel) {
  const Network network = expand(parse_routing("M-1-T-2-F"));
  const TensionState state = tensions(network, mechanics(network, {}), Grasp{});
  std::string text = "run,routing,held,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  for (int row = 0; row < 6; ++row) {
    const bool odd = row == 5;
    text += fmt::format("{},M-1-T-2-F,{},{}", row, odd ? "1" : "", 20 + row);
    for (std::size_t i = 0; i < 4; ++i) {
      const double times = odd && i == odd_channel ? factor : 1;
      text += fmt::format(",{}", (20 + row) * state.tension[i + 1] * times);
    }
    text += '\n';
  }
  return text;
}

// What a diagnosis would hand over: the odd channel stands apart, and the model knows better.
struct Handed {
  MeasuredData data;
  Model model;
  std::vector<ComparedCell> cells;
  std::vector<Loss> losses;

  explicit Handed(std::size_t odd_channel) : data(read_data(readings(odd_channel))) {
    add_effect(model, {find_cause("tube_friction"), {}, {0.2}});
    cells = cells_as_measured(data);
    for (ComparedCell& cell : cells) {
      if (cell.cell.reading == 5 && cell.cell.channel == odd_channel) cell.after_N /= factor;
    }
    Loss loss;
    loss.grasp = hold({1});
    loss.high = data.channels[1].segment;
    loss.low = data.channels[2].segment;
    losses.push_back(loss);
    loss.grasp = Grasp{};
    losses.push_back(loss);
    losses[0].stands_apart = true;
  }

  std::optional<WithoutApart> without(const Noise& noise) const {
    Workers workers(1);
    return without_apart(data, model, {noise, {}}, cells, losses, workers);
  }
};

constexpr double wide_N = 3;
const Noise of_residuals{0, wide_N, diagnosis::NoiseSource::residuals, 20};
const Noise of_repeats{0, wide_N, diagnosis::NoiseSource::repeats, 20};

double width(const WithoutApart& found) {
  const ParameterInterval& interval = found.intervals.at(0).at(0);
  return interval.high - interval.low;
}

TEST(WithoutApart, LeavesOutTheReadingThatTheModelMeetsLessWell) {
  for (const std::size_t odd : {std::size_t{1}, std::size_t{2}}) {
    const Handed handed(odd);
    const auto found = handed.without(of_residuals);
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->left_out.size(), 1U);
    EXPECT_EQ(found->left_out[0].reading, 5U);
    EXPECT_EQ(found->left_out[0].channel, odd);
    // As near as a fit ends.
    EXPECT_NEAR(found->model.effects.at(0).values.at(0), Hardware{}.tube.mu, 1e-5);
  }
}

// T2 is off by more, T3 by more of what it should be.
TEST(WithoutApart, LeavesOutTheEndThatIsFurtherOffInProportion) {
  Handed handed(2);
  for (ComparedCell& cell : handed.cells) {
    if (cell.cell.reading != 5) continue;
    cell.after_N = cell.cell.measured_N;
    if (cell.cell.channel == 1) cell.after_N *= 1.2;
    if (cell.cell.channel == 2) cell.after_N *= 1.3;
  }
  const ComparedCell &high = handed.cells[21], &low = handed.cells[22];
  ASSERT_GT(high.after_N - high.cell.measured_N, low.after_N - low.cell.measured_N);
  EXPECT_EQ(handed.without(of_residuals)->left_out.at(0).channel, 2U);
}

TEST(WithoutApart, LeavesAReadingOutOnceHoweverManyStretchesEndAtIt) {
  Handed handed(2);
  Loss next = handed.losses[0];
  next.high = handed.data.channels[2].segment;
  next.low = handed.data.channels[3].segment;
  handed.losses.push_back(next);
  EXPECT_EQ(handed.without(of_residuals)->left_out.size(), 1U);
}

// The grasp is not all that a stretch is of.
TEST(WithoutApart, LeavesOutNoReadingOfReleasingOrOfAnotherRouting) {
  Handed released(2), other(2);
  released.data.readings[0].grasp = other.data.readings[0].grasp = hold({1});
  released.data.readings[0].direction = Direction::release;
  other.data.routings.push_back(other.data.routings[0]);
  other.data.readings[0].routing = 1;
  for (const Handed& handed : {released, other}) {
    const auto found = handed.without(of_residuals);
    ASSERT_EQ(found->left_out.size(), 1U);
    EXPECT_EQ(found->left_out[0].reading, 5U);
  }
}

// Which the odd reading made; what repeats show, it did not.
TEST(WithoutApart, EstimatesTheNoiseThatTheModelLeavesAnew) {
  const Handed handed(2);
  EXPECT_LT(10 * width(*handed.without(of_residuals)), width(*handed.without(of_repeats)));
}

// Over both grasps, of all readings: the odd one is as far off as it is.
TEST(WithoutApart, HasTheShareErrorOfAllReadings) {
  const Handed handed(2);
  std::vector<double> read, expected;
  for (std::size_t i = 20; i < 24; ++i) {
    read.push_back(handed.cells[i].cell.measured_N);
    expected.push_back(i == 22 ? read.back() / factor : read.back());
  }
  const double error = share_distance(read, expected) / 2;
  Handed blind = handed;
  for (ComparedCell& cell : blind.cells) {
    cell.before_N = 1;
    if (cell.cell.channel == 0) cell.after_N = 1;
  }
  EXPECT_NEAR(*blind.without(of_residuals)->share_error, error, 1e-5);
}

TEST(WithoutApart, IsNothingWhereNoneStandsApartOrNothingIsFitted) {
  Handed handed(2);
  handed.model.effects.clear();
  EXPECT_FALSE(handed.without(of_residuals).has_value());
  handed = Handed(2);
  handed.losses[0].stands_apart = false;
  EXPECT_FALSE(handed.without(of_residuals).has_value());
}

}  // namespace
}  // namespace reeve::testing
