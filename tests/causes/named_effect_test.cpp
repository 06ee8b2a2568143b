#include "causes/named_effect.hpp"

#include <gtest/gtest.h>

#include "causes/library.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/planned.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

class NamedEffects : public ::testing::Test {
 protected:
  NamedEffects() : plan_(plan_of({"M-1-T-2-F", "M-1-P-2-M"})) {
    plan_.speed_mm_s = PlannedLevels{{1, 100}, {}};
    plan_.cycle = PlannedLevels{{0, 3000}, {}};
    plan_.temperature_C = PlannedLevels{{15, 35}, {}};
    plan_.directions = {Direction::pull, Direction::release};
    plan_.sheath_angle_rad = PlannedLevels{{1, 6}, {}};
  }

  Effect effect(const std::string& name, const std::vector<Setting>& settings = {}) const {
    return effect_of({name, settings}, survey(plan_), hardware_);
  }
  std::string error(const std::string& name, const std::vector<Setting>& settings = {}) const {
    return input_error([&] { effect(name, settings); });
  }

  ExperimentPlan plan_;
  Hardware hardware_;
};

// A bearing stands in the second routing.
TEST_F(NamedEffects, AreReadForEveryCauseAndSubjectOfTheLibrary) {
  const Survey possible = survey(plan_);
  for (const Cause* cause : cause_library()) {
    const std::vector<Subject> subjects = cause->subjects(possible);
    EXPECT_FALSE(subjects.empty()) << cause->name();
    for (const Subject& subject : subjects) {
      std::vector<Setting> settings;
      for (const Parameter& parameter : cause->parameters(hardware_)) {
        settings.push_back({parameter.name, std::to_string(parameter.range.high)});
      }
      if (subject.recorded) {
        settings = {{"recorded", to_text(*subject.recorded)}, {"actual", to_text(*subject.actual)}};
      }
      const std::string expected = effect_name(Effect{cause, subject, {}});
      const Effect found = effect(expected, settings);
      EXPECT_EQ(effect_name(found), expected);
      EXPECT_EQ(found.subject.recorded, subject.recorded);
      EXPECT_EQ(found.subject.actual, subject.actual);
      EXPECT_EQ(found.values.size(), cause->parameters(hardware_).size());
    }
  }
}

TEST_F(NamedEffects, TakeAContactInEitherOrderUnlessTwoJoinItsSegments) {
  const auto named = [&](const std::string& name) { return effect(name).subject.contact; };
  EXPECT_EQ(named("seized_contact[M-1-T-2-F,T2-T1]"), "T1-T2");
  EXPECT_EQ(named("seized_contact[M-1-P-2-M,T1-a]"), "a-T1");
  EXPECT_NE(error("seized_contact[M-1-T-2-F,T1-T3]"), "");
  plan_ = plan_of({"M-Y1+1-Y1-1"});
  EXPECT_EQ(named("seized_contact[M-Y1+1-Y1-1,T2-T1]"), "T2-T1");
  EXPECT_EQ(named("seized_contact[M-Y1+1-Y1-1,T1-T2]"), "T1-T2");
}

TEST_F(NamedEffects, AreInTheDocumentWithTheirParameters) {
  const std::string document =
      read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "model.md");
  for (const Cause* cause : cause_library()) {
    const std::size_t at = document.find("\n| `" + std::string(cause->name()));
    const std::size_t beside = document.find(", `" + std::string(cause->name()) + "`");
    const std::size_t line = std::min(at, beside);
    ASSERT_NE(line, std::string::npos) << cause->name();
    const std::string row = document.substr(line, document.find('\n', line + 1) - line);
    for (const Parameter& parameter : cause->parameters(hardware_)) {
      EXPECT_NE(row.find('`' + std::string(parameter.name) + '`'), std::string::npos)
          << cause->name() << parameter.name;
    }
  }
}

TEST_F(NamedEffects, SayTheirSize) {
  EXPECT_EQ(size_text(effect("sensor_gain[T3]", {{"gain", "1.08"}}), hardware_), "gain = 1.08");
  EXPECT_EQ(size_text(effect("pretension", {{"tension_N", "2"}}), hardware_), "tension_N = 2 N");
  EXPECT_EQ(size_text(effect("wrong_grasp[M-1-P-2-M]"), hardware_), "recorded none, really 1");
  EXPECT_EQ(
      size_text(effect("wrong_grasp[M-1-P-2-M]", {{"recorded", "2"}, {"actual", "1"}}), hardware_),
      "recorded 2, really 1");
  EXPECT_EQ(size_text(effect("seized_contact[M-1-P-2-M,T1-T2]"), hardware_), "");
}

TEST_F(NamedEffects, TakeTheMiddleOfTheLiteratureWhereAParameterThatIsNoSizeIsNotSet) {
  EXPECT_EQ(size_text(effect("wear", {{"change", "-0.4"}}), hardware_),
            "change = -0.4, cycles = 320");
  EXPECT_EQ(size_text(effect("wear", {{"cycles", "50"}, {"change", "-0.4"}}), hardware_),
            "change = -0.4, cycles = 50");
}

TEST_F(NamedEffects, ThatCannotBeReadSayWhatWasExpected) {
  EXPECT_TRUE(error("ware").starts_with("'ware': unknown cause 'ware'; expected one of tube_"));
  EXPECT_EQ(error("sensor_gain[T9]", {{"gain", "1.1"}}),
            "'sensor_gain[T9]': this experiment has no such thing; expected sensor_gain[T1], "
            "sensor_gain[T2], sensor_gain[T3], sensor_gain[T4]");
  EXPECT_EQ(error("sensor_gain"),
            "'sensor_gain': this experiment has no such thing; expected sensor_gain[T1], "
            "sensor_gain[T2], sensor_gain[T3], sensor_gain[T4]");
  EXPECT_EQ(error("wear[T1]"), "'wear[T1]': this experiment has no such thing; expected wear");
  EXPECT_EQ(error("wear", {{"depth", "1"}}),
            "'wear': unknown parameter 'depth'; expected change, cycles");
  EXPECT_EQ(error("wear", {{"change", "3"}}),
            "'wear': change = '3': expected a number from -1 to 2");
  EXPECT_EQ(error("wear", {{"change", "nan"}}),
            "'wear': change = 'nan': expected a number from -1 to 2");
  EXPECT_EQ(error("wear", {{"change", "1"}, {"change", "1"}}), "'wear': 'change' is set twice");
  EXPECT_EQ(error("wear", {{"cycles", "100"}}),
            "'wear': its size is missing: expected change=VALUE, from -1 to 2");
  EXPECT_EQ(error("seized_contact[M-1-P-2-M,T1-T2]", {{"force", "1"}}),
            "'seized_contact[M-1-P-2-M,T1-T2]': unknown parameter 'force'; expected none: it is "
            "there or not");
  EXPECT_EQ(error("wrong_grasp[M-1-P-2-M]", {{"actual", "1,2"}}),
            "'wrong_grasp[M-1-P-2-M]': actual = '1,2': expected one of 1 or 2 or none");
}

TEST_F(NamedEffects, ThatTheExperimentCannotShowSayWhatItLacks) {
  plan_.speed_mm_s.reset();
  plan_.cycle.reset();
  plan_.temperature_C.reset();
  EXPECT_EQ(error("speed_dependent_friction"),
            "'speed_dependent_friction': it depends on the speed: expected it to be given");
  EXPECT_EQ(error("wear"), "'wear': it depends on the cycle: expected it to be given");
  EXPECT_EQ(error("temperature"),
            "'temperature': it depends on the temperature: expected it to be given");
  plan_.directions = {Direction::release};
  EXPECT_EQ(error("hysteresis"),
            "'hysteresis': pulling and releasing differ by it: expected readings of both "
            "directions");
  plan_.sheath_angle_rad = PlannedLevels{{}, {3}};
  EXPECT_EQ(error("wrap_free_loss"),
            "'wrap_free_loss': it shows where sheath angles differ: expected more than one of "
            "them");
  plan_.routings.pop_back();
  EXPECT_EQ(
      error("bearing_drag"),
      "'bearing_drag': the experiment has no routing, channel or part that it could be about");
}

}  // namespace
}  // namespace reeve::testing
