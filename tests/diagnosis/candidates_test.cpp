#include "diagnosis/search/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "causes/library.hpp"
#include "diagnosis/dataset.hpp"
#include "diagnosis/diagnosis_result.hpp"
#include "diagnosis/fit/fit.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

MeasuredData two_fingers() {
  return read_data(
      "run,routing,held,motor_tension_N,cycle,T1_N,T3_N\n"
      "1,M-1-T-2-F,1,20,5,6,3\n1,M-1-T-2-F,,20,6,6,3\n");
}

const Effect& named(const std::vector<Effect>& all, const std::string& name) {
  return *std::ranges::find(all, name, effect_name);
}

TEST(Candidates, AreTheCausesThatTheDataCouldShowAboutEachSubject) {
  const MeasuredData data = two_fingers();
  std::multiset<std::string> names;
  for (const Effect& each : candidates(survey(data), {})) names.insert(effect_name(each));
  EXPECT_EQ(names.count("tube_friction"), 1U);
  EXPECT_EQ(names.count("bearing_friction"), 0U);  // there is none
  EXPECT_EQ(names.count("wear"), 1U);
  EXPECT_EQ(names.count("temperature"), 0U);  // no column
  EXPECT_EQ(names.count("sensor_gain[T1]") + names.count("sensor_gain[T3]"), 2U);
  EXPECT_EQ(names.count("sensor_gain[T2]"), 0U);
  EXPECT_EQ(names.count("seized_contact[M-1-T-2-F,T1-T2]"), 1U);
  // Recorded "1" could be "2" or none, and none could be either.
  EXPECT_EQ(names.count("wrong_grasp[M-1-T-2-F]"), 4U);
}

TEST(Candidates, HaveTheirNominalSize) {
  const MeasuredData data = two_fingers();
  Hardware hardware;
  hardware.tube.mu = 0.11;
  const auto all = candidates(survey(data), hardware);
  EXPECT_EQ(named(all, "tube_friction").values, std::vector<double>{0.11});
  EXPECT_EQ(named(all, "sensor_gain[T1]").values, std::vector<double>{1});
  EXPECT_TRUE(named(all, "wrong_grasp[M-1-T-2-F]").values.empty());
  // A shape has no nominal value: the middle of 10 to 1e5 cycles stands for it.
  EXPECT_EQ(named(all, "wear").values[0], 0);
  EXPECT_NEAR(named(all, "wear").values[1], 1000, 1e-9);
}

// Of 10 to 1e5 cycles: in the middle of five equal parts of the four orders of magnitude.
TEST(Candidates, AreTriedAtFiveShapesOverTheirRange) {
  const MeasuredData data = two_fingers();
  const auto all = candidates(survey(data), {});
  const auto of = [&](const std::string& name) {
    return shapes(named(all, name), named(all, name).cause->parameters({}));
  };
  const auto tried = of("wear");
  ASSERT_EQ(tried.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(tried[i][0], 0);
    EXPECT_NEAR(std::log10(tried[i][1]), 1.4 + 0.8 * static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(of("tube_friction").size(), 1U);
}

TEST(SameEffect, IsOfTheSameCauseAndSubjectWhateverItsSize) {
  const Cause* gain = find_cause("sensor_gain");
  const auto of = [&](const char* channel, double value) {
    Effect effect{gain, {}, {value}};
    effect.subject.channel = parse_segment(channel);
    return effect;
  };
  EXPECT_TRUE(same_effect(of("T1", 1), of("T1", 2)));
  EXPECT_FALSE(same_effect(of("T1", 1), of("T3", 1)));
  Effect offset = of("T1", 1);
  offset.cause = find_cause("sensor_offset");
  EXPECT_FALSE(same_effect(of("T1", 1), offset));
}

TEST(SameEffect, TellsWrongGraspsOfOneRoutingApart) {
  const auto of = [](int recorded, int actual) {
    Effect effect{find_cause("wrong_grasp"), {}, {}};
    effect.subject.routing = "M-1-T-2-F";
    effect.subject.recorded = hold({recorded});
    effect.subject.actual = hold({actual});
    return effect;
  };
  EXPECT_TRUE(same_effect(of(1, 2), of(1, 2)));
  EXPECT_FALSE(same_effect(of(1, 2), of(3, 2)));
  EXPECT_FALSE(same_effect(of(1, 2), of(1, 3)));
  EXPECT_EQ(grasps_text(of(1, 2).subject), "recorded 1, measured 2");
}

}  // namespace
}  // namespace reeve::testing
