#include "reports/output/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/version.hpp"

namespace reeve {
namespace {

TEST(JsonNumber, IsNullWhereThereIsNone) {
  EXPECT_EQ(number(0.25).dump(), "0.25");
  EXPECT_EQ(number(std::nan("")).dump(), "null");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity()).dump(), "null");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity()).dump(), "null");
}

TEST(JsonNumber, KeepsEveryBit) {
  const double third = 1.0 / 3.0;
  EXPECT_EQ(Json::parse(number(third).dump()).get<double>(), third);
}

TEST(PrintedJson, EndsItsLineAndSurvivesTextThatIsNoUtf8) {
  EXPECT_EQ(print({{"a", 1}}), "{\n  \"a\": 1\n}\n");
  EXPECT_EQ(Json::parse(print({{"a", "x\xFF"}}))["a"], "x\uFFFD");
}

TEST(JsonObjectives, AreNumbersOrNullAndCountsAreIntegers) {
  ObjectiveValues values{};
  values.fill(2);
  values[static_cast<std::size_t>(Objective::uniformity_mean)] = std::nan("");
  Json json;
  add_objectives(json, values);
  EXPECT_EQ(
      json.dump(),
      R"({"uniformity":{"mean":null,"worst":2.0},"efficiency":{"mean":2.0,"worst":2.0},)"
      R"("force_transmission":2.0,"jams":2,"jams_all":2,"sheaths":2,"pulleys":2,"knots":2,"travel":2.0,)"
      R"("round_trip_efficiency":2.0,"adaptability":2.0,)"
      R"("torsional_balance":2.0,"reliability":2.0,)"
      R"("authors_efficiency":2.0,"transmission":2.0,"score":2.0,"blocks":2,)"
      R"("finger_uniformity":{"mean":2.0,"worst":2.0},"parts":2,"cost":2.0,)"
      R"("uniformity_p5":2.0,"efficiency_p5":2.0,)"
      R"("hand":{"motor_force":2.0,"fingertip_force":{"mean":2.0,"worst":2.0},)"
      R"("stroke":2.0,"closure":2.0,"motor_power":2.0}})");
}

TEST(JsonObjectives, HaveNoHandWhereThereIsNone) {
  Json json;
  add_objectives(json, ObjectiveValues{});
  EXPECT_FALSE(json.contains("hand"));
  EXPECT_TRUE(json.contains("finger_uniformity"));
}

TEST(JsonHardware, NamesOnlyWhatIsSetForAFingerOrAContact) {
  Hardware hardware;
  FingerHardware finger;
  finger.finger = 2;
  finger.tip_mu = 0.09;
  hardware.fingers.push_back(finger);
  ContactHardware contact;
  contact.segment = "a";
  contact.other_segment = "T1";
  contact.mu = 0.2;
  hardware.contacts.push_back(contact);
  const Json json = to_json(hardware);
  EXPECT_EQ(json["fingers"].dump(), R"([{"finger":2,"tip_mu":0.09}])");
  hardware.fingers[0].closing = 0.5;
  EXPECT_EQ(to_json(hardware)["fingers"].dump(), R"([{"finger":2,"tip_mu":0.09,"closing":0.5}])");
  EXPECT_EQ(json["contacts"].dump(), R"([{"between":["a","T1"],"mu":0.2}])");
}

TEST(JsonVersion, NamesTheReleaseAndTheCommit) {
  EXPECT_EQ(version_json(), version().number + " (" + version().commit + ")");
}

}  // namespace
}  // namespace reeve
