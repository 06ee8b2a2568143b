#include "causes/library.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/causes/rig.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Solved;
using testing::Trial;

// Everything that a rig with this routing could show.
Survey survey_of(const Trial& trial) {
  Survey survey;
  survey.routings.push_back({to_word(trial.routing), &trial.network, {trial.grasp}});
  survey.channels = survey.wide_channels = trial.network.segments;
  survey.has_speed = survey.has_cycle = survey.has_temperature = true;
  survey.has_motor_tension = survey.has_both_directions = survey.sheath_angle_varies = true;
  survey.reads_below_zero = true;
  return survey;
}

TEST(CauseLibrary, HasEveryCauseOfTheInterfaceOnce) {
  std::set<std::string> names;
  for (const Cause* cause : cause_library()) {
    EXPECT_TRUE(names.insert(cause->name()).second) << cause->name();
    EXPECT_EQ(find_cause(cause->name()), cause);
  }
  const std::set<std::string> expected{"tube_friction",
                                       "sheath_friction",
                                       "bearing_friction",
                                       "bending_stiffness",
                                       "bearing_drag",
                                       "load_dependent_friction",
                                       "wear",
                                       "temperature",
                                       "speed_dependent_friction",
                                       "sensor_gain",
                                       "sensor_offset",
                                       "pretension",
                                       "sheath_angle",
                                       "wrong_grasp",
                                       "seized_contact",
                                       "wrap_free_loss",
                                       "hysteresis",
                                       "motor_gain",
                                       "motor_offset",
                                       "constant_loss",
                                       "viscous_loss",
                                       "cross_talk",
                                       "dead_zone",
                                       "dead_channel",
                                       "drift",
                                       "saturation",
                                       "swapped_channels"};
  EXPECT_EQ(names, expected);
  EXPECT_EQ(find_cause("rust"), nullptr);
}

TEST(CauseLibrary, HasSensibleParameters) {
  for (const Cause* cause : cause_library()) {
    bool first = true;
    for (const Parameter& parameter : cause->parameters(Hardware{})) {
      SCOPED_TRACE(std::string(cause->name()) + "." + parameter.name);
      EXPECT_EQ(parameter.nominal.has_value(), first);
      if (parameter.nominal) {
        EXPECT_LE(parameter.range.low, *parameter.nominal);
        EXPECT_GE(parameter.range.high, *parameter.nominal);
      }
      if (parameter.literature) {
        EXPECT_LE(parameter.range.low, parameter.literature->low);
        EXPECT_GE(parameter.range.high, parameter.literature->high);
      }
      first = false;
    }
  }
}

// Without a routing there is no contact and no grasp, whatever else the data tell.
TEST(CauseLibrary, AsksForNoPartThatIsNotThere) {
  Survey survey;
  survey.channels = survey.wide_channels = {parse_segment("T1"), parse_segment("T2")};
  survey.has_speed = survey.has_cycle = survey.has_temperature = true;
  survey.has_motor_tension = survey.has_both_directions = survey.sheath_angle_varies = true;
  for (const Cause* cause : cause_library()) {
    if (cause->reach() == Reach::motor || cause->reach() == Reach::reading) continue;
    EXPECT_TRUE(cause->subjects(survey).empty()) << cause->name();
  }
}

// One recorded grasp was really one other: of two effects about it, one is too many.
TEST(Effects, CanConflictThoughTheirParametersDiffer) {
  const auto wrong_grasp = [](int recorded, int actual) {
    Subject subject;
    subject.routing = "M-1-T-2-T-3-F";
    subject.recorded = hold({recorded});
    subject.actual = hold({actual});
    return testing::effect("wrong_grasp", {}, subject);
  };
  EXPECT_TRUE(is_about_the_same(wrong_grasp(1, 2), wrong_grasp(1, 3)));
  EXPECT_FALSE(is_about_the_same(wrong_grasp(1, 3), wrong_grasp(2, 3)));
  const auto gain = [](const char* channel, double value) {
    Subject subject;
    subject.channel = parse_segment(channel);
    return testing::effect("sensor_gain", {value}, subject);
  };
  EXPECT_TRUE(is_about_the_same(gain("T1", 1.1), gain("T1", 1.2)));
  EXPECT_FALSE(is_about_the_same(gain("T1", 1.1), gain("T2", 1.1)));
  EXPECT_FALSE(is_about_the_same(gain("T1", 1.1), gain("a", 1.1)));
  Effect offset = gain("T1", 1.1);
  offset.cause = find_cause("sensor_offset");
  EXPECT_FALSE(is_about_the_same(gain("T1", 1.1), offset));
}

TEST(Effects, OfTwoChannelsAreTheSameWhicheverComesFirst) {
  const auto swapped = [](const char* one, const char* other) {
    Subject subject;
    subject.channel = parse_segment(one);
    subject.other_channel = parse_segment(other);
    return testing::effect("swapped_channels", {}, subject);
  };
  EXPECT_TRUE(is_about_the_same(swapped("T1", "T2"), swapped("T2", "T1")));
  EXPECT_FALSE(is_about_the_same(swapped("T1", "T2"), swapped("T1", "T3")));
}

// Two columns can be exchanged if both have a reading at once; of more than 8 columns none is
// tried.
TEST(SwappedChannels, ArePairsThatSomeRoutingHasBothOf) {
  const Network network = expand(parse_routing("M-1-T-2-F"));
  Survey survey;
  survey.routings.push_back({"M-1-T-2-F", &network, {Grasp{}}});
  survey.channels = {parse_segment("T1"), parse_segment("T3"), parse_segment("T7")};
  const Cause& cause = *find_cause("swapped_channels");
  ASSERT_EQ(cause.subjects(survey).size(), 1U);
  EXPECT_EQ(cause.subject_name(cause.subjects(survey)[0]), "T1,T3");
  for (const char* more : {"T2", "T4", "a", "T8", "T9"}) {
    survey.channels.push_back(parse_segment(more));
  }
  for (int more = 10; survey.channels.size() < 16; ++more) {
    survey.channels.push_back(parse_segment("T" + std::to_string(more)));
  }
  EXPECT_EQ(cause.subjects(survey).size(), 10U);
  survey.channels.push_back(parse_segment("T99"));
  EXPECT_TRUE(cause.subjects(survey).empty());
}

// What the seam promises to whoever keeps or prints a model.
TEST(CauseLibrary, UsesTheMembersOfTheSubjectThatItSays) {
  const Trial trial = testing::random_trial(3);
  for (const Cause* cause : cause_library()) {
    SCOPED_TRACE(cause->name());
    const SubjectKind kind = cause->subject_kind();
    for (const Subject& subject : cause->subjects(survey_of(trial))) {
      const bool of_two = kind == SubjectKind::channels;
      EXPECT_EQ(subject.channel.has_value(), of_two || kind == SubjectKind::channel);
      EXPECT_EQ(subject.other_channel.has_value(), of_two);
      EXPECT_EQ(subject.finger > 0, kind == SubjectKind::finger);
      EXPECT_EQ(subject.recorded.has_value(), kind == SubjectKind::grasp);
      EXPECT_EQ(subject.actual.has_value(), kind == SubjectKind::grasp);
      EXPECT_EQ(!subject.contact.empty(), kind == SubjectKind::contact);
      EXPECT_EQ(!subject.routing.empty(),
                kind == SubjectKind::grasp || kind == SubjectKind::contact);
      EXPECT_EQ(cause->subject_name(subject).empty(), kind == SubjectKind::rig);
    }
  }
}

TEST(CauseLibrary, LeavesNoExponentBelowZero) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Dice dice(seed);
    for (const Cause* cause : cause_library()) {
      const Effect effect = testing::random_effect(dice, *cause, Hardware{});
      const ContactLoad load{ContactKind::sheath, dice.log_real(0.1, 100), 0, Direction::release};
      Conditions conditions = testing::random_conditions(dice);
      conditions.temperature_C = dice.real(-100, 300);
      EXPECT_GE(cause->exponent(1, load, conditions, effect), 0) << effect_name(effect);
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000);
}

// A recorded grasp may have been any other in which something closes; with five fingers and more,
// one with at most one finger held.
TEST(WrongGrasp, IsTriedAsEveryOtherGraspOfUpToFourFingers) {
  for (const auto& [word, others] : {std::pair{"M-1-F", 0U},
                                     {"M-1-T-2-F", 2U},
                                     {"M-1-T-2-T-3-T-4-F", 14U},
                                     {"M-1-T-2-T-3-T-4-T-5-F", 5U}}) {
    const Network network = expand(parse_routing(word));
    Survey survey;
    survey.routings.push_back({word, &network, {Grasp{}}});
    EXPECT_EQ(find_cause("wrong_grasp")->subjects(survey).size(), others) << word;
  }
}

// Of sensors on every segment, where each tension is another one.
std::vector<double> readings(const Model& model, const Network& network) {
  std::vector<Sensor> sensors;
  for (const Segment& segment : network.segments) {
    sensors.push_back({segment, 3.25 + 0.1 * static_cast<double>(sensors.size()), sensors.size()});
  }
  read(model, Direction::pull, model.conditions, sensors);
  std::vector<double> result;
  for (const Sensor& sensor : sensors) result.push_back(sensor.reading_N);
  return result;
}

// At its nominal size a cause changes no bit of any prediction.
TEST(CauseLibrary, ChangesNothingAtTheNominalValue) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Trial trial = testing::random_trial(seed);
    SCOPED_TRACE(testing::to_text(trial));
    Dice dice(seed);
    Model plain{trial.hardware};
    plain.conditions = testing::random_conditions(dice);
    const Solved expected = testing::solved(plain, trial.routing, trial.grasp, trial.direction);
    for (const Cause* cause : cause_library()) {
      if (cause->parameters(trial.hardware).empty()) continue;
      for (const Subject& subject : cause->subjects(survey_of(trial))) {
        Model model = plain;
        Effect effect = testing::random_effect(dice, *cause, trial.hardware);
        effect.subject = subject;
        effect.values[0] = *cause->parameters(trial.hardware)[0].nominal;
        add_effect(model, effect);
        const Solved s = testing::solved(model, trial.routing, trial.grasp, trial.direction);
        EXPECT_EQ(s.state.tension, expected.state.tension) << effect_name(effect);
        EXPECT_EQ(at_tendon(model, trial.direction, model.conditions).motor_tension_N,
                  plain.conditions.motor_tension_N)
            << effect_name(effect);
        EXPECT_EQ(readings(model, trial.network), readings(plain, trial.network))
            << effect_name(effect);
        ++compared;
      }
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(compared, 2000);
}

}  // namespace
}  // namespace reeve
