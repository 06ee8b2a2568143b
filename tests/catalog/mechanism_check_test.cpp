#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/mechanisms/mechanism_file.hpp"
#include "catalog/mechanisms/named_values.hpp"
#include "catalog/number_check.hpp"

namespace reeve {
namespace {

// One sheave that lets r = 0.5 through, so that a gun tackle lifts 0.5 + 0.25 times its pull.
const std::string tackle =
    "name = \"X\"\nword = \"M-B-Y1-F+Y1-1x\"\naccess = \"read\"\n"
    "[hardware]\nsheath = { mu = 0 }\n"
    "[rig.half]\ninferred_from = \"50 % of one\"\nlet = { r = 0.5 }\n"
    "hardware = { bearing = { mu = \"-ln(r)/pi\" } }\n";

CheckItem item(const std::string& keys) {
  const std::string text = tackle +
                           "[[published]]\nsource = \"p. 1\"\nrig = \"half\"\nnumbers = [\n"
                           "  { quantity = \"load over pull\", " +
                           keys + " },\n]\n";
  return check_mechanism(read_mechanism(parse_toml(text, "x.toml"), "tackles")).items.at(0);
}

TEST(MechanismCheck, SaysOfANumberWhoseAndWhatItIs) {
  const CheckItem found = item("computed = \"T1/T_M\", value = \"0.75\"");
  EXPECT_EQ(found.family, "tackles");
  EXPECT_EQ(found.routing, "X");
  EXPECT_EQ(found.source, "p. 1");
  EXPECT_EQ(found.in_words, "load over pull");
  EXPECT_EQ(found.printed, "0.75");
  EXPECT_EQ(found.published, 0.75);
  EXPECT_DOUBLE_EQ(found.computed, 0.75);
  EXPECT_EQ(found.inferred_from, "50 % of one");
  EXPECT_EQ(found.status, CheckStatus::agrees);
  EXPECT_EQ(found.reason, "");
}

TEST(MechanismCheck, AgreesToThePrintedRoundingOrTheTolerance) {
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.8\"").status, CheckStatus::agrees);
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.80\"").status, CheckStatus::differs);
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.80\", tolerance = 0.06").status,
            CheckStatus::agrees);
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.80\", tolerance = 0.04").status,
            CheckStatus::differs);
}

TEST(MechanismCheck, HoldsAClosedFormToNineDigits) {
  EXPECT_EQ(item("computed = \"T1/T_M\", equals = \"r + r^2\"").status, CheckStatus::agrees);
  const CheckItem wrong = item("computed = \"T1/T_M\", equals = \"r + r^2 + 0.00000001\"");
  EXPECT_EQ(wrong.status, CheckStatus::differs);
  EXPECT_EQ(wrong.printed, "");
}

TEST(MechanismCheck, SaysHowMuchANumberDiffersThatNothingIsListedFor) {
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.60\"").reason,
            "0.60 is published and 0.75 computed (-20.0 %), and nothing is listed for it");
}

TEST(MechanismCheck, CountsNoAgreementOfTheNumberThatACoefficientIsFrom) {
  EXPECT_EQ(item("computed = \"T1/T_M\", value = \"0.75\", used = true").status, CheckStatus::used);
  const CheckItem wrong = item("computed = \"T1/T_M\", value = \"0.70\", used = true");
  EXPECT_EQ(wrong.status, CheckStatus::differs);
  EXPECT_EQ(wrong.reason,
            "0.70 is published and 0.75 computed (-6.7 %), though the coefficient is said to be "
            "its");
}

TEST(MechanismCheck, ExplainsANumberOnlyByArithmeticThatGivesIt) {
  const CheckItem explained =
      item("computed = \"T1/T_M\", value = \"1.0\", explained_by = \"2*r\", because = \"twice\"");
  EXPECT_EQ(explained.status, CheckStatus::explained);
  EXPECT_EQ(explained.reason, "1.0 is published and 0.75 computed (+33.3 %); 2*r = 1: twice");
  const CheckItem not_it =
      item("computed = \"T1/T_M\", value = \"1.0\", explained_by = \"3*r\", because = \"thrice\"");
  EXPECT_EQ(not_it.status, CheckStatus::differs);
  EXPECT_EQ(not_it.reason,
            "1.0 is published and 0.75 computed (+33.3 %); 3*r = 1.5, which is listed for it, does "
            "not give it");
}

TEST(MechanismCheck, LeavesOpenWhatIsListedAsOpenAndSaysItsSize) {
  const CheckItem open = item("computed = \"T1/T_M\", value = \"1.5\", open = \"nobody knows\"");
  EXPECT_EQ(open.status, CheckStatus::open);
  EXPECT_EQ(open.reason, "1.5 is published and 0.75 computed (+100.0 %); nobody knows");
}

// Or a list would hide numbers that have come to agree.
TEST(MechanismCheck, BelievesNoListOfWhatAgrees) {
  const CheckItem open = item("computed = \"T1/T_M\", value = \"0.75\", open = \"nobody knows\"");
  EXPECT_EQ(open.status, CheckStatus::differs);
  EXPECT_EQ(open.reason, "it agrees, though x.toml:14:3 lists it as one that differs");
  EXPECT_EQ(
      item("computed = \"T1/T_M\", value = \"0.75\", explained_by = \"r\", because = \"b\"").status,
      CheckStatus::differs);
}

TEST(MechanismCheck, FailsANumberThatIsNone) {
  EXPECT_EQ(item("computed = \"0/0\", value = \"0.75\"").status, CheckStatus::differs);
}

const CheckReport& shipped_mechanisms() {
  static const CheckReport report = [] {
    CheckReport all;
    for (const Mechanism& mechanism : read_catalogue(REEVE_CATALOG_DIR).mechanisms) {
      for (CheckItem& item : check_mechanism(mechanism).items) all.items.push_back(item);
    }
    return all;
  }();
  return report;
}

TEST(CheckOfTheShippedMechanisms, LeavesNothingUnlisted) {
  const CheckReport& report = shipped_mechanisms();
  EXPECT_EQ(report.count(CheckStatus::differs), 0U);
  EXPECT_EQ(report.count(CheckStatus::agrees), 73U);
  EXPECT_EQ(report.count(CheckStatus::used), 7U);
  EXPECT_EQ(report.count(CheckStatus::explained), 22U);
  EXPECT_EQ(report.count(CheckStatus::open), 70U);
}

// Worked out here by the sum of a geometric series, without any routing.
TEST(CheckOfTheShippedMechanisms, FindsTheSheaveTableInTheWordsOfItsTackles) {
  std::size_t numbers = 0;
  for (const CheckItem& item : shipped_mechanisms().items) {
    if (item.source != "Hanes") continue;
    const double k = item.in_words.find("bronze") != std::string::npos ? 1.045 : 1.02;
    const bool counted = item.routing == "HoistReeving";
    const std::vector<std::string> small{"SingleWhip",      "GunTackle",      "LuffTackle",
                                         "TwofoldPurchase", "FivePartTackle", "ThreefoldPurchase"};
    const auto parts =
        counted ? std::stoi(item.in_words)
                : 1 + static_cast<int>(std::find(small.begin(), small.end(), item.routing) -
                                       small.begin());
    EXPECT_NEAR(item.computed, (1 - std::pow(k, -parts)) / (k - 1), 1e-9) << item.in_words;
    EXPECT_NEAR(item.computed, item.published, item.published < 10 ? 0.0101 : 0.101);
    ++numbers;
  }
  EXPECT_EQ(numbers, 48U);
}

TEST(CheckOfTheShippedMechanisms, LeavesWhatArithmeticDoesNotShowOpen) {
  for (const CheckItem& item : shipped_mechanisms().items) {
    if (item.source == "Workshop Receipts" && item.routing != "SingleWhip" &&
        item.in_words.find("actual power") == std::string::npos) {
      EXPECT_EQ(item.status, CheckStatus::open) << item.routing;
    }
    if (item.routing == "PulleyTurns90") {
      EXPECT_EQ(item.status, CheckStatus::open);
    }
    if (item.source == "US Navy 14043") {
      EXPECT_EQ(item.status, CheckStatus::explained);
    }
  }
}

TEST(NamedValues, AreTheCoefficientsAndWhatTheSolverFinds) {
  const Mechanism mechanism = read_mechanism(
      parse_toml("name = \"X\"\nword = \"1x-P-2x\"\naccess = \"read\"\n"
                 "[hardware]\ntube = { mu = 0.1, angle_rad = 1 }\nblock = { mu = 0.2 }\n"
                 "sheath = { mu = 0.3, angle_rad = 2 }\nbearing = { mu = 0.4, angle_rad = 3 }\n"
                 "[[published]]\nsource = \"s\"\nheld = [1]\nnumbers = [\n"
                 "  { quantity = \"q\", computed = \"T1\", value = \"1\" },\n]\n",
                 "x.toml"),
      "gloves");
  const NamedValues values = solved_values(mechanism.numbers[0]);
  EXPECT_EQ(values.at("mu_t"), 0.1);
  EXPECT_EQ(values.at("theta_t"), 1);
  EXPECT_EQ(values.at("mu_block"), 0.2);
  EXPECT_EQ(values.at("theta_block"), 3);
  EXPECT_EQ(values.at("mu_s"), 0.3);
  EXPECT_EQ(values.at("theta_s"), 2);
  EXPECT_EQ(values.at("mu_b"), 0.4);
  EXPECT_EQ(values.at("theta_b"), 3);
  EXPECT_EQ(values.at("T_M"), 1);
  EXPECT_NEAR(values.at("a") + values.at("b"), 1, 1e-12);
  EXPECT_NEAR(values.at("T3") / values.at("T1"), std::exp(-1.2), 1e-12);
  // The held finger gives nothing up, and the other one both sides of the pulley.
  EXPECT_EQ(values.at("dl1"), 0);
  EXPECT_NEAR(values.at("dl2"), 2, 1e-5);
  EXPECT_NEAR(values.at("uniformity"), std::exp(-1.2), 1e-12);
  EXPECT_NEAR(values.at("efficiency"), 2 * values.at("T3"), 1e-5);
}

}  // namespace
}  // namespace reeve
