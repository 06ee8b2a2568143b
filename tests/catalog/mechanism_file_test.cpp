#include "catalog/mechanisms/mechanism_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catalog/mistake.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::Mistake;

const std::string mechanism_head = "name = \"X\"\nword = \"M-B-Y1-F+Y1-1x\"\naccess = \"read\"\n";
const std::string worn_rig =
    "[rig.worn]\ninferred_from = \"90 % of one\"\nlet = { K = 1.1 }\n"
    "hardware = { bearing = { mu = \"ln(K)/pi\" } }\n";

std::string one_number(const std::string& number, const std::string& beside = "") {
  return "[[published]]\nsource = \"p. 1\"\n" + beside + "numbers = [\n  { " + number + " },\n]\n";
}

Mechanism mechanism_of(const std::string& text) {
  return read_mechanism(parse_toml(text, "x.toml"), "tackles");
}

std::string mechanism_error(const std::string& text) {
  return testing::message_of<InputError>([&] { mechanism_of(text); });
}

TEST(MechanismFile, KeepsTheWordAsItIsSpeltBesideTheCanonicalRouting) {
  const Mechanism mechanism = mechanism_of(mechanism_head);
  EXPECT_EQ(mechanism.family, "tackles");
  EXPECT_EQ(mechanism.word, "M-B-Y1-F+Y1-1x");
  EXPECT_NE(mechanism.routing, mechanism.canonical);
  EXPECT_EQ(mechanism.access, "read");
  EXPECT_FALSE(mechanism.from_secondary_source);
  EXPECT_FALSE(mechanism.hardware);
  EXPECT_TRUE(mechanism.numbers.empty());
}

TEST(MechanismFile, HasTheMechanismForOtherNumbersOfFingers) {
  const Mechanism mechanism = mechanism_of(mechanism_head + "like = [\"M-B-Y1-F+Y1-1x+M-2x\"]\n");
  ASSERT_EQ(mechanism.like.size(), 1U);
  EXPECT_EQ(finger_count(mechanism.like[0]), 2);
  const std::string expected = "expected a word for a number of fingers that none before it has";
  for (const char* like : {"[\"M-1-F\"]", "[\"M-1-T-2-F\", \"M-2-T-1-F\"]"}) {
    const std::string error = mechanism_error(mechanism_head + "like = " + like + "\n");
    EXPECT_NE(error.find(expected), std::string::npos) << error;
  }
}

TEST(MechanismFile, ReadsExpressionsWhereAHardwareHasNumbers) {
  const Mechanism mechanism = mechanism_of(
      mechanism_head + "[hardware]\nbearing = { mu = \"-ln(0.8)/pi\" }\nsheath = { mu = 0 }\n");
  ASSERT_TRUE(mechanism.hardware);
  EXPECT_DOUBLE_EQ(mechanism.hardware->bearing.exponent(), -std::log(0.8));
  EXPECT_EQ(mechanism.hardware->sheath.mu, 0);
  EXPECT_EQ(mechanism.hardware->tube.mu, Hardware{}.tube.mu);
}

TEST(MechanismFile, LaysARigOverTheMechanismsOwnHardware) {
  const Mechanism mechanism = mechanism_of(
      mechanism_head + "[hardware]\nbearing = { mu = 0.3, angle_rad = 2 }\nsheath = { mu = 0 }\n" +
      worn_rig + one_number("quantity = \"q\", rig = \"worn\", computed = \"K\", value = \"1\"") +
      one_number("quantity = \"q\", computed = \"T1\", value = \"1\""));
  ASSERT_EQ(mechanism.numbers.size(), 2U);
  const MechanismRig& worn = mechanism.numbers[0].rig;
  EXPECT_DOUBLE_EQ(worn.hardware.bearing.mu, std::log(1.1) / std::numbers::pi);
  EXPECT_EQ(worn.hardware.bearing.angle_rad, 2);
  EXPECT_EQ(worn.hardware.sheath.mu, 0);
  EXPECT_EQ(worn.inferred_from, "90 % of one");
  EXPECT_EQ(mechanism.numbers[1].rig.hardware.bearing.mu, 0.3);
  EXPECT_EQ(mechanism.numbers[1].rig.inferred_from, "");
}

TEST(MechanismFile, DefinesWhatLetSaysInTheOrderOfTheFile) {
  const Mechanism mechanism =
      mechanism_of(mechanism_head + "[rig.a]\nlet = { K = 2, r = \"1/K\", turn = \"2*pi\" }\n" +
                   one_number("quantity = \"q\", rig = \"a\", computed = \"r\", value = \"1\""));
  const NamedValues& let = mechanism.numbers[0].rig.let;
  EXPECT_EQ(let.at("r"), 0.5);
  EXPECT_DOUBLE_EQ(let.at("turn"), 2 * std::numbers::pi);
}

TEST(MechanismFile, LaysTheLetOfANumberOverThatOfItsRig) {
  const Mechanism mechanism =
      mechanism_of(mechanism_head + worn_rig +
                   one_number("quantity = \"q\", rig = \"worn\", let = { K = 1.2, n = \"2*K\" }, "
                              "computed = \"T1\", value = \"1\""));
  const MechanismRig& rig = mechanism.numbers[0].rig;
  EXPECT_DOUBLE_EQ(rig.hardware.bearing.mu, std::log(1.2) / std::numbers::pi);
  EXPECT_EQ(rig.let.at("n"), 2.4);
  EXPECT_EQ(rig.inferred_from, "90 % of one");
}

// Student's t of two degrees of freedom at 97.5 % is 4.3027; the readings' deviation is 1.
TEST(MechanismFile, MakesOfReadingsTheirMeanAndEachOfThem) {
  const Mechanism mechanism =
      mechanism_of(mechanism_head + one_number("quantity = \"q\", computed = \"T1\", "
                                               "trials = [\"9.0\", \"10.0\", \"11.0\"]"));
  ASSERT_EQ(mechanism.numbers.size(), 4U);
  const PublishedNumber& mean = mechanism.numbers[0];
  EXPECT_EQ(mean.quantity, "q");
  EXPECT_EQ(mean.printed.digits, "10.0 ± 2.5");
  EXPECT_DOUBLE_EQ(mean.printed.value, 10);
  EXPECT_NEAR(mean.printed.half_unit, 4.3027 / std::sqrt(3), 1e-4);
  const PublishedNumber& last = mechanism.numbers[3];
  EXPECT_EQ(last.quantity, "q, reading 3 of 3");
  EXPECT_EQ(last.printed.digits, "11.0");
  EXPECT_NEAR(last.printed.half_unit, 4.3027 * std::sqrt(4.0 / 3), 1e-4);
}

TEST(MechanismFile, GivesANumberWhatStandsBesideTheNumbersUnlessItHasItsOwn) {
  const Mechanism mechanism =
      mechanism_of(mechanism_head +
                   "[[published]]\nsource = \"p. 1\"\nheld = [1]\ncomputed = \"T1\"\nunit = \"N\"\n"
                   "open = \"nobody knows\"\nnumbers = [\n"
                   "  { quantity = \"a\", value = \"1.50\" },\n"
                   "  { quantity = \"b\", where = \"Eq. 2\", word = \"M-2x+M-1x\", held = [2],"
                   " computed = \"T3\", unit = \"lb\", value = \"2\", tolerance = 0.1,"
                   " explained_by = \"1 + 1\", because = \"sum\" },\n]\n");
  const PublishedNumber& a = mechanism.numbers[0];
  EXPECT_EQ(a.quantity, "a, N");
  EXPECT_EQ(a.source, "p. 1");
  EXPECT_EQ(a.word, mechanism.word);
  EXPECT_EQ(a.grasp, hold({1}));
  EXPECT_EQ(a.computed.text(), "T1");
  EXPECT_EQ(a.printed.half_unit, 0.005);
  EXPECT_EQ(a.standing, NumberStanding::open);
  EXPECT_EQ(a.reason, "nobody knows");
  const PublishedNumber& b = mechanism.numbers[1];
  EXPECT_EQ(b.quantity, "b, lb");
  EXPECT_EQ(b.source, "p. 1, Eq. 2");
  EXPECT_EQ(b.word, "M-2x+M-1x");
  EXPECT_EQ(b.grasp, hold({2}));
  EXPECT_EQ(b.printed.half_unit, 0.1);
  EXPECT_EQ(b.standing, NumberStanding::explained);
  EXPECT_EQ(b.reason, "sum");
}

TEST(BadMechanismFile, NamesThePlaceOfAMistakeInItsHead) {
  const std::vector<Mistake> mistakes = {
      {"word = \"M-1x\"\n", "x.toml:1:1: missing key 'name': expected the mechanism's name"},
      {"name = \"M\"\nword = \"M-1x\"\n",
       "x.toml:1:1: missing key 'access': expected what of the source was read"},
      {"name = \"X\"\nword = \"F-1x\"\naccess = \"a\"\n",
       "x.toml:2:8: word = \"F-1x\": expected a routing whose tendons all hang on the motor"},
      {"name = \"X\"\nword = \"M-F\"\naccess = \"a\"\n",
       "x.toml:2:8: word = \"M-F\": expected a routing with fingers"},
      {mechanism_head + "topology = \"guessed\"\n",
       "x.toml:4:12: topology = \"guessed\": expected \"read\" or \"secondary\""},
      {mechanism_head + "hardware = { bearing = { mu = \"1/\" } }\n",
       "x.toml:4:31: expression '1/', column 3: found '': expected a number, a name or '('"},
      {mechanism_head + "hardware = { bearing = { mu = \"-1\" } }\n",
       "x.toml:4:31: hardware.bearing.mu = -1: expected a finite number, not negative"},
      {mechanism_head + "hardware = { sheaf = { mu = 1 } }\n",
       "x.toml:4:14: unknown key 'hardware.sheaf': expected one of tube, bearing, block, sheath, "
       "lengths, finger, contact, spools, tendon, uncertainty, hand, motor, vary"},
      {mechanism_head + "[rig.a]\nlet = { pi = 3 }\n",
       "x.toml:5:9: let 'pi': expected a new name of letters, digits and '_', such as K or P1"},
      {mechanism_head + "[rig.a]\nlet = { 2K = 3 }\n",
       "x.toml:5:9: let '2K': expected a new name of letters, digits and '_', such as K or P1"},
  };
  for (const Mistake& mistake : mistakes) EXPECT_EQ(mechanism_error(mistake.text), mistake.message);
}

TEST(BadMechanismFile, NamesThePlaceOfAMistakeInANumber) {
  const std::string ok = "quantity = \"q\", computed = \"T1\", ";
  const std::vector<Mistake> mistakes = {
      {"quantity = \"q\", value = \"1\"",
       "x.toml:8:3: missing key 'computed' in 'published[1].numbers[1]': expected what of the "
       "tensions it is, such as \"T1/T_M\""},
      {ok + "value = 1.5",
       "x.toml:8:46: published[1].numbers[1].value = 1.5: expected a number in quotes, with the "
       "digits as printed, such as \"0.10\""},
      {ok + "unit = \"N\"",
       "x.toml:8:3: published[1].numbers[1]: expected one of value, equals and trials"},
      {ok + "value = \"1\", equals = \"1\"",
       "x.toml:8:3: published[1].numbers[1]: expected one of value, equals and trials"},
      {ok + "equals = \"1\", tolerance = 1",
       "x.toml:8:64: published[1].numbers[1].tolerance = 1: expected none but beside value"},
      {ok + "trials = [\"1\"]",
       "x.toml:8:47: published[1].numbers[1].trials = (an array): expected at least two readings: one has no "
       "spread"},
      {ok + "trials = [\"1\", \"2\"], open = \"a\"",
       "x.toml:8:38: published[1].numbers[1].trials: expected nothing but used beside it: readings "
       "are of a quantity that the model gives"},
      {ok + "value = \"1\", direction = \"up\"",
       "x.toml:8:63: published[1].numbers[1].direction = \"up\": expected \"pull\" or \"release\""},
      {ok + "value = \"1\", open = \"a\", explained_by = \"1\"",
       "x.toml:8:3: published[1].numbers[1]: expected at most one of used, explained_by, open "
       "and refuted"},
      {ok + "value = \"1\", explained_by = \"1\"",
       "x.toml:8:3: missing key 'because' in 'published[1].numbers[1]': expected what the "
       "expression is"},
      {ok + "value = \"1\", used = true",
       "x.toml:8:58: published[1].numbers[1].used = true: expected a rig with inferred_from"},
      {ok + "value = \"1\", rig = \"new\"",
       "x.toml:8:57: published[1].numbers[1].rig = \"new\": expected nothing, there is no "
       "[rig.NAME]"},
      {"quantity = \"q\", computed = \"T1 + T2\", value = \"1\"",
       "x.toml:8:32: expression 'T1 + T2', column 6: found 'T2': expected one of T1, T_M, a, dl1, "
       "efficiency, h1, h2, h3, mu_b, mu_block, mu_s, mu_t, pi, theta_b, theta_block, theta_s, "
       "theta_t, uniformity"},
      {ok + "value = \"1\", held = [2]",
       "x.toml:8:59: published[1].numbers[1].held[1] = 2: expected a whole number from 1 to 1"},
  };
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(mechanism_error(mechanism_head + "\n" + one_number(mistake.text)), mistake.message);
  }
}

TEST(BadMechanismFile, NamesAnUnknownRigAndTheKnownOnes) {
  EXPECT_EQ(mechanism_error(
                mechanism_head + worn_rig +
                one_number("quantity = \"q\", computed = \"T1\", value = \"1\", rig = \"w\"")),
            "x.toml:11:57: published[1].numbers[1].rig = \"w\": expected one of worn");
}

TEST(BadMechanismFile, NamesWhatLetDefinesThoughTheWordHasIt) {
  EXPECT_EQ(mechanism_error(
                mechanism_head + "[rig.a]\nlet = { h1 = 3 }\n" +
                one_number("quantity = \"q\", rig = \"a\", computed = \"T1\", value = \"1\"")),
            "x.toml:9:3: let 'h1': expected a name that no segment or coefficient has");
}

TEST(BadMechanismFile, NamesAContactThatTheWordHasNot) {
  EXPECT_EQ(mechanism_error(mechanism_head + "[hardware.contact.\"T1-T2\"]\nmu = 0.1\n" +
                            one_number("quantity = \"q\", computed = \"T1\", value = \"1\"")),
            "x.toml:9:3: contact 'T1-T2': expected two segments with a contact between them in "
            "M-B-Y1-F+Y1-1x");
}

// What was not read cannot be checked as if it had been.
TEST(BadMechanismFile, HasNoNumbersOfASecondarySource) {
  EXPECT_EQ(mechanism_error(mechanism_head + "topology = \"secondary\"\n" +
                            one_number("quantity = \"q\", computed = \"T1\", value = \"1\"")),
            "x.toml:5:1: published: expected no numbers of a mechanism whose topology is "
            "secondary");
  EXPECT_TRUE(mechanism_of(mechanism_head + "topology = \"secondary\"\npublished = []\n")
                  .from_secondary_source);
}

}  // namespace
}  // namespace reeve
