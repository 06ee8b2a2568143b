// Files as loggers and people leave them, of planted readings: what is read of them, and what the
// diagnosis makes of it (bench/confusion --part dirty has rates).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/planting_dirt.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

std::string clean_file() {
  PlantingPlan plan;
  plan.effects = {EffectKind::sensor_gain};
  return plant(plan, 81).csv;
}

DiagnosisResult diagnosis_of_file(const std::string& csv) {
  DiagnoseOptions options;
  options.replicates = 100;
  return diagnose(read_data(csv), Hardware{}, options);
}

std::vector<std::string> names_in(const DiagnosisResult& result) {
  std::vector<std::string> names;
  for (const NamedCause& cause : result.causes) names.push_back(cause.name);
  return names;
}

TEST(DirtyFile, OfAnotherFormHasTheSameReadings) {
  const MeasuredData clean = read_data(clean_file());
  const MeasuredData dirty = read_data(dirtied(clean_file(), Dirt::form, 82));
  ASSERT_EQ(dirty.readings.size(), clean.readings.size());
  EXPECT_EQ(dirty.runs, clean.runs);
  for (std::size_t i = 0; i < clean.readings.size(); ++i) {
    EXPECT_EQ(dirty.readings[i].tension_N, clean.readings[i].tension_N) << i;
    EXPECT_EQ(dirty.readings[i].motor_tension_N, clean.readings[i].motor_tension_N) << i;
    EXPECT_EQ(dirty.readings[i].grasp, clean.readings[i].grasp) << i;
    EXPECT_EQ(dirty.readings[i].direction, clean.readings[i].direction) << i;
    EXPECT_EQ(dirty.readings[i].temperature_C, clean.readings[i].temperature_C) << i;
  }
}

TEST(DirtyFile, IsDiagnosedAsTheCleanOne) {
  SKIP_UNDER_SANITIZERS();
  const DiagnosisResult clean = diagnosis_of_file(clean_file());
  ASSERT_EQ(clean.verdict, Verdict::cause);
  for (const Dirt dirt : {Dirt::form, Dirt::copies}) {
    const DiagnosisResult dirty = diagnosis_of_file(dirtied(clean_file(), dirt, 83));
    EXPECT_EQ(dirty.verdict, clean.verdict) << dirt_name(dirt);
    ASSERT_EQ(names_in(dirty), names_in(clean)) << dirt_name(dirt);
    EXPECT_EQ(dirty.rows, clean.rows) << dirt_name(dirt);
    // The order of the rows is one of the things that noise is estimated beside, and copies shift
    // it.
    const EstimatedParameter& size = clean.causes.front().parameters.front();
    const double part = dirt == Dirt::form ? 0 : 0.02;
    EXPECT_NEAR(dirty.causes.front().parameters.front().value, size.value,
                part * (size.high - size.low))
        << dirt_name(dirt);
  }
}

// A sensor that reads 0 throughout has no noise: neither do the others seem surer by it, nor does
// it look as if something went on along it.
TEST(DirtyFile, WithADeadSensorHasThatBesideTheCause) {
  SKIP_UNDER_SANITIZERS();
  MeasuredData data = read_data(clean_file());
  const auto T2 = std::find_if(data.channels.begin(), data.channels.end(),
                               [](const Channel& channel) { return channel.name == "T2"; });
  ASSERT_NE(T2, data.channels.end());
  for (Reading& reading : data.readings) {
    auto& tension_N = reading.tension_N[static_cast<std::size_t>(T2 - data.channels.begin())];
    if (tension_N) tension_N = 0;
  }
  DiagnoseOptions options;
  options.replicates = 100;
  const DiagnosisResult dead = diagnose(data, Hardware{}, options);
  std::vector<std::string> expected = names_in(diagnosis_of_file(clean_file()));
  expected.emplace_back("dead_channel[T2]");
  std::vector<std::string> found = names_in(dead);
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(dead.verdict, Verdict::cause);
}

// Sizes are of readings that weigh by how far out they are.
TEST(DirtyFile, WithSpikesHasTheSameCause) {
  SKIP_UNDER_SANITIZERS();
  const DiagnosisResult clean = diagnosis_of_file(clean_file());
  const DiagnosisResult dirty = diagnosis_of_file(dirtied(clean_file(), Dirt::spikes, 84));
  EXPECT_EQ(names_in(dirty), names_in(clean));
  const EstimatedParameter& size = dirty.causes.at(0).parameters.at(0);
  EXPECT_LE(size.low, clean.causes.at(0).parameters.at(0).value);
  EXPECT_GE(size.high, clean.causes.at(0).parameters.at(0).value);
}

}  // namespace
}  // namespace reeve::testing
