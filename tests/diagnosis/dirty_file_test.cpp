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
  plan.runs = 8;
  return plant(plan, 81).csv;
}

DiagnosisResult diagnosed_file(const MeasuredData& data) {
  DiagnoseOptions options;
  options.replicates = 100;
  return diagnose(data, Hardware{}, options);
}

DiagnosisResult diagnosis_of_file(const std::string& csv) { return diagnosed_file(read_data(csv)); }

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

std::vector<std::string> sorted_names_in(const DiagnosisResult& result) {
  std::vector<std::string> names = names_in(result);
  std::sort(names.begin(), names.end());
  return names;
}

MeasuredData with_dead_sensor(MeasuredData data, const std::string& name) {
  const auto dead = std::find_if(data.channels.begin(), data.channels.end(),
                                 [&](const Channel& channel) { return channel.name == name; });
  const auto c = static_cast<std::size_t>(dead - data.channels.begin());
  for (Reading& reading : data.readings) {
    if (reading.tension_N[c]) reading.tension_N[c] = 0;
  }
  return data;
}

TEST(DirtyFile, IsDiagnosedAsTheCleanOne) {
  SKIP_UNDER_SANITIZERS();
  const DiagnosisResult clean = diagnosis_of_file(clean_file());
  ASSERT_EQ(clean.verdict, Verdict::cause);
  const EstimatedParameter& size = clean.causes.front().parameters.front();

  // The order of the rows is one of the things that noise is estimated beside, and copies shift it.
  const DiagnosisResult copied = diagnosis_of_file(dirtied(clean_file(), Dirt::copies, 83));
  EXPECT_EQ(copied.verdict, clean.verdict);
  ASSERT_EQ(names_in(copied), names_in(clean));
  EXPECT_EQ(copied.rows, clean.rows);
  EXPECT_NEAR(copied.causes.front().parameters.front().value, size.value,
              0.02 * (size.high - size.low));

  // Sizes are of readings that weigh by how far out they are.
  const DiagnosisResult spiked = diagnosis_of_file(dirtied(clean_file(), Dirt::spikes, 84));
  EXPECT_EQ(names_in(spiked), names_in(clean));
  EXPECT_LE(spiked.causes.at(0).parameters.at(0).low, size.value);
  EXPECT_GE(spiked.causes.at(0).parameters.at(0).high, size.value);

  // A sensor that reads 0 throughout has no noise: neither do the others seem surer by it, nor does
  // it look as if something went on along it.
  const DiagnosisResult dead = diagnosed_file(with_dead_sensor(read_data(clean_file()), "T2"));
  std::vector<std::string> expected = names_in(clean);
  expected.emplace_back("dead_channel[T2]");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(sorted_names_in(dead), expected);
  EXPECT_EQ(dead.verdict, Verdict::cause);
}

}  // namespace
}  // namespace reeve::testing
