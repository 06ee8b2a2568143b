#include "catalog/model_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "causes/library.hpp"
#include "core/notation.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::Mistake;
using testing::TemporaryFolder;
using testing::Trial;

ModelFile model_file_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_model_file(folder.write("m.toml", text));
}

std::string error_in_model(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_model_file(folder.write("m.toml", text)); });
}

std::string error_in_effect(const std::string& keys) {
  return error_in_model("[[effect]]\n" + keys);
}

void expect_same(const Subject& a, const Subject& b) {
  EXPECT_EQ(a.channel, b.channel);
  EXPECT_EQ(a.other_channel, b.other_channel);
  EXPECT_EQ(a.finger, b.finger);
  EXPECT_EQ(a.routing, b.routing);
  EXPECT_EQ(a.contact, b.contact);
  EXPECT_EQ(a.recorded, b.recorded);
  EXPECT_EQ(a.actual, b.actual);
}

void expect_same(const Hardware& a, const Hardware& b) {
  EXPECT_EQ(a.tube, b.tube);
  EXPECT_EQ(a.bearing, b.bearing);
  EXPECT_EQ(a.sheath, b.sheath);
  EXPECT_EQ(a.block, b.block);
  EXPECT_EQ(a.strand_mm, b.strand_mm);
  EXPECT_EQ(a.motor_side_mm, b.motor_side_mm);
  EXPECT_EQ(a.hand_mm, b.hand_mm);
  EXPECT_EQ(a.fingers, b.fingers);
  EXPECT_EQ(a.contacts, b.contacts);
}

void expect_same(const Model& a, const Model& b) {
  expect_same(a.hardware, b.hardware);
  for (const ConditionRow& row : condition_table()) {
    EXPECT_EQ(a.conditions.*row.value, b.conditions.*row.value) << row.name;
  }
  ASSERT_EQ(a.effects.size(), b.effects.size());
  for (std::size_t i = 0; i < a.effects.size(); ++i) {
    SCOPED_TRACE(effect_name(a.effects[i]));
    EXPECT_EQ(a.effects[i].cause, b.effects[i].cause);
    EXPECT_EQ(a.effects[i].values, b.effects[i].values);
    expect_same(a.effects[i].subject, b.effects[i].subject);
  }
}

bool is_new(const Effect& effect, const Model& model) {
  for (const Effect& other : model.effects) {
    if (is_about_the_same(effect, other)) return false;
  }
  return true;
}

// Some effects of every cause, with any of its subjects that this routing gives.
Model random_model(std::uint64_t seed) {
  const Trial trial = testing::random_trial(seed);
  Dice dice(seed);
  Survey survey;
  survey.routings.push_back({to_word(trial.routing), &trial.network, {trial.grasp}});
  survey.channels = survey.wide_channels = trial.network.segments;
  survey.has_speed = survey.has_cycle = survey.has_temperature = true;
  survey.has_motor_tension = survey.has_both_directions = survey.sheath_angle_varies = true;
  survey.reads_below_zero = true;
  Hardware hardware = trial.hardware;
  if (dice.chance(0.5)) hardware.block = ContactLaw{dice.real(0, 0.3), dice.real(0, 6)};
  hardware.contacts.erase(hardware.contacts.begin() + (hardware.contacts.empty() ? 0 : 1),
                          hardware.contacts.end());  // each contact once
  Model model{hardware};
  for (const Cause* cause : cause_library()) {
    for (const Subject& subject : cause->subjects(survey)) {
      Effect effect{cause, subject, {}};
      for (const Parameter& parameter : cause->parameters(hardware)) {
        effect.values.push_back(dice.real(parameter.range.low, parameter.range.high));
      }
      if (cause->reach() != Reach::hardware && dice.chance(0.3) && is_new(effect, model)) {
        add_effect(model, effect);
      }
    }
  }
  model.conditions = {dice.log_real(0.1, 1e4), dice.log_real(0.1, 1e4), dice.log_real(1, 1e8),
                      dice.real(-50, 100)};
  return model;
}

TEST(ModelFile, ReadsBackWhatIsWrittenBitByBit) {
  std::size_t effects = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Model model = random_model(seed);
    model.hardware.scatter = {0.1 / 3, 0.2 / 3};
    const UncertaintyRanges ranges{{0.1 / 3, 0.7 / 3}, {0, 1e-7}, 1.0 / 3, 0};
    const ModelFile file = model_file_of(model_toml(model, {"a model"}, ranges));
    expect_same(file.model, model);
    EXPECT_EQ(file.model.hardware.scatter, model.hardware.scatter);
    EXPECT_EQ(file.uncertainty.tube_mu.low, ranges.tube_mu.low);
    EXPECT_EQ(file.uncertainty.sheath_mu.high, ranges.sheath_mu.high);
    EXPECT_EQ(file.uncertainty.bearing_mu_relative, ranges.bearing_mu_relative);
    EXPECT_EQ(file.uncertainty.sheath_angle_relative, ranges.sheath_angle_relative);
    effects += model.effects.size();
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(effects, 500U);
}

TEST(ModelFile, KeepsEffectsOnTheHardwareBesideIt) {
  Model model;
  Subject finger;
  finger.finger = 2;
  add_effect(model, {find_cause("sheath_angle"), finger, {0.7}});
  add_effect(model, {find_cause("tube_friction"), {}, {0.09}});
  expect_same(model_file_of(model_toml(model, {})).model, model);
  EXPECT_EQ(model_toml(model_file_of(model_toml(model, {})).model, {}), model_toml(model, {}));
}

TEST(ModelFile, TakesAnyTextAsAComment) {
  const std::vector<std::string> lines{
      "from \xFF\xFE.csv",     "two\nlines\r", std::string(9000, 'x'), "μ = 0.09", "",
      std::string("\0\x7F", 2)};
  const std::string text = model_toml(Model{}, lines);
  EXPECT_EQ(text.find("# from ??.csv\n# two?lines?\n"), 0U);
  EXPECT_NE(text.find("# μ = 0.09\n"), std::string::npos);
  expect_same(model_file_of(text).model, Model{});
}

TEST(ModelFile, IsThePlainModelWhereNothingIsGiven) {
  expect_same(model_file_of("").model, Model{});
  expect_same(model_file_of("[conditions]\n").model, Model{});
}

TEST(ModelFile, SortsEffectsInTheOrderOfTheLibrary) {
  const Model model = model_file_of(
                          "[[effect]]\ncause = \"bending_stiffness\"\nforce_N = 1\n"
                          "[[effect]]\ncause = \"wear\"\nchange = -0.25\ncycles = 100\n")
                          .model;
  ASSERT_EQ(model.effects.size(), 2U);
  EXPECT_STREQ(model.effects[0].cause->name(), "wear");
  EXPECT_EQ(model.effects[0].values, (std::vector<double>{-0.25, 100}));
}

TEST(ModelFile, ReadsTheExample) {
  const ModelFile file = read_model_file(std::string(REEVE_CATALOG_DIR) + "/model/example.toml");
  EXPECT_EQ(file.model.hardware.sheath.mu, 0.15);
  ASSERT_EQ(file.model.effects.size(), 6U);
  EXPECT_EQ(effect_name(file.model.effects[2]), "sheath_angle[2]");
  EXPECT_EQ(effect_name(file.model.effects[3]), "seized_contact[M-1-P-2-M,T1-T2]");
  EXPECT_EQ(effect_name(file.model.effects[5]), "law[exponent of sheath, humidity_pct, linear]");
}

TEST(TermsFile, HasLawsAlone) {
  const TemporaryFolder folder;
  const std::string law =
      "[[law]]\nacts_on = \"gain\"\nsite = \"T3\"\nform = \"constant\"\na = 0.1\n";
  const std::vector<Effect> terms = read_terms_file(folder.write("t.toml", law), {});
  ASSERT_EQ(terms.size(), 1U);
  EXPECT_EQ(effect_name(terms[0]), "law[gain of T3]");
  EXPECT_EQ(terms[0].values, std::vector{0.1});
  const auto error = [&](const std::string& text) {
    return folder.error_of([&] { read_terms_file(folder.write("t.toml", text), {}); });
  };
  EXPECT_EQ(error(""), "t.toml:1:1: missing key 'law': expected one [[law]] at least");
  EXPECT_EQ(error("[sheath]\nmu = 0.1\n"), "t.toml:1:2: unknown key 'sheath': expected one of law");
  EXPECT_EQ(error(law + law),
            "t.toml:6:1: law[2]: law[gain of T3] is given twice: expected each effect once");
}

TEST(BadModelFile, NamesThePlaceOfABadEffect) {
  const std::vector<Mistake> mistakes = {
      {"cause = \"rust\"\n",
       "m.toml:2:9: effect[1].cause = \"rust\": expected one of " + cause_names()},
      {"", "m.toml:1:1: missing key 'cause' in 'effect[1]': expected one of " + cause_names()},
      {"cause = \"wear\"\nchange = 0.1\n",
       "m.toml:1:1: missing key 'cycles' in 'effect[1]': expected a number from 10 to 100000"},
      {"cause = \"tube_friction\"\nmu = 0.1\nnu = 1\n",
       "m.toml:4:1: unknown key 'effect[1].nu': expected one of cause, mu"},
      {"cause = \"tube_friction\"\nmu = 0.7\n",
       "m.toml:3:6: effect[1].mu = 0.7: expected a number from 0 to 0.6"},
      {"cause = \"tube_friction\"\nmu = nan\n",
       "m.toml:3:6: effect[1].mu = nan: expected a number from 0 to 0.6"},
      {"cause = \"bending_stiffness\"\nforce_N = true\n",
       "m.toml:3:11: effect[1].force_N = true: expected a number from 0 to 5000"},
      {"cause = \"tube_friction\"\nmu = 0.1\n[[effect]]\ncause = \"tube_friction\"\nmu = 0.2\n",
       "m.toml:4:1: effect[2]: tube_friction is given twice: expected each effect once"},
      {"cause = \"sheath_angle\"\nfinger = 1\nangle_rad = 0\n[[effect]]\ncause = \"sheath_angle\"\n"
       "finger = 1\nangle_rad = 1\n",
       "m.toml:5:1: effect[2]: sheath_angle[1] is given twice: expected each effect once"},
  };
  for (const Mistake& mistake : mistakes) EXPECT_EQ(error_in_effect(mistake.text), mistake.message);
}

TEST(ModelFile, TakesNamesOfTheCatalogueForRoutings) {
  const TemporaryFolder folder;
  const Catalogue catalogue = read_catalogue(std::filesystem::path(REEVE_CATALOG_DIR));
  const ModelFile file =
      read_model_file(folder.write("m.toml",
                                   "[[effect]]\ncause = \"seized_contact\"\nrouting = \"tr5\"\n"
                                   "contact = \"T1-T2\"\n"),
                      catalogue);
  EXPECT_EQ(file.model.effects[0].subject.routing, "M-1-P-2-M");
}

TEST(ModelFile, NamesAContactInWalkOrder) {
  const auto contact_of = [](const std::string& routing) {
    const TemporaryFolder folder;
    return read_model_file(
               folder.write("m.toml", "[[effect]]\ncause = \"seized_contact\"\nrouting = \"" +
                                          routing + "\"\ncontact = \"T2-T1\"\n"),
               Catalogue{})
        .model.effects[0]
        .subject.contact;
  };
  EXPECT_EQ(contact_of("M-1-F"), "T1-T2");
  EXPECT_EQ(contact_of("M-Y1+1-Y1-1"), "T2-T1");
}

TEST(BadModelFile, NamesThePlaceOfABadSubject) {
  const std::vector<Mistake> mistakes = {
      {"cause = \"sensor_gain\"\ngain = 1.1\n",
       "m.toml:1:1: missing key 'channel' in 'effect[1]': expected a strand (T1), a motor-side "
       "segment (a) or a stretch at the hand (h1), in quotes"},
      {"cause = \"sensor_gain\"\nchannel = \"Q1\"\ngain = 1.1\n",
       "m.toml:3:11: effect[1].channel = \"Q1\": expected a strand (T1), a motor-side segment (a) "
       "or a stretch at the hand (h1), in quotes"},
      {"cause = \"sheath_angle\"\nfinger = 0\nangle_rad = 1\n",
       "m.toml:3:10: effect[1].finger = 0: expected a whole number from 1 to 64"},
      {"cause = \"seized_contact\"\nrouting = \"M-1-Q\"\ncontact = \"T1-T2\"\n",
       "m.toml:3:11: effect[1].routing: routing 'M-1-Q', column 5: unknown token 'Q': expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1"},
      {"cause = \"seized_contact\"\nrouting = \"M-1-F\"\ncontact = \"T2-T3\"\n",
       "m.toml:4:11: effect[1].contact = \"T2-T3\": expected one of a-T1, T1-T2"},
      {"cause = \"wrong_grasp\"\nrouting = \"M-1-F\"\nrecorded = \"3\"\nactual = \"none\"\n",
       "m.toml:4:12: effect[1].recorded: held '3': '3': expected none or 1"},
      {"cause = \"wrong_grasp\"\nrouting = \"M-1-F\"\nrecorded = \"1\"\nactual = \"1\"\n",
       "m.toml:5:10: effect[1].actual = \"1\": expected another grasp than 'recorded'"},
  };
  for (const Mistake& mistake : mistakes) EXPECT_EQ(error_in_effect(mistake.text), mistake.message);
}

TEST(BadModelFile, NamesThePlaceOfABadCondition) {
  EXPECT_EQ(error_in_model("[conditions]\nmotor_tension_N = 0\n"),
            "m.toml:2:19: conditions.motor_tension_N = 0: expected a number from 0.01 to 100000");
  EXPECT_EQ(error_in_model("[conditions]\nspeed = 1\n"),
            "m.toml:2:1: unknown key 'conditions.speed': expected one of motor_tension_N, "
            "speed_mm_s, cycle, temperature_C; did you mean speed_mm_s?");
  EXPECT_EQ(error_in_model("[effect]\ncause = \"wear\"\n"),
            "m.toml:1:1: effect = (a table): expected tables headed [[effect]]");
  EXPECT_EQ(
      error_in_model("[tubes]\n"),
      "m.toml:1:2: unknown key 'tubes': expected one of tube, bearing, block, sheath, lengths, "
      "finger, contact, spools, tendon, uncertainty, hand, motor, vary, conditions, effect, law; did you mean tube?");
}

// The range of a parameter is not that of its product with the others.
TEST(BadModelFile, NamesTheEffectThatMakesFrictionTooStrong) {
  EXPECT_EQ(error_in_model("[sheath]\nmu = 0.1\nangle_rad = 90\n[[effect]]\ncause = "
                           "\"sheath_friction\"\nmu = 0.2\n"),
            "m.toml:4:1: hardware: sheath: mu * angle = 18: expected at most 10");
}

TEST(ModelFileFault, KeepsThePartsOfWhatIsReadInsideIt) {
  const TemporaryFolder folder;
  const auto parts = [&](const std::string& text) {
    return testing::input_fault([&] { read_model_file(folder.write("m.toml", text)); });
  };
  const std::string file = (folder.path() / "m.toml").string();
  EXPECT_EQ(parts("[tube]\nmu = 11\n"),
            file + ":1:2: hardware | tube.mu | 11 | a number from 0 to 10");
  EXPECT_EQ(
      parts("[[effect]]\ncause = \"wrong_grasp\"\nrouting = \"M-1-Q\"\n"),
      file +
          ":3:11: effect[1].routing: routing 'M-1-Q', column 5 | unknown token | Q | M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1");
}

}  // namespace
}  // namespace reeve
