// Readings of held-out runs that no training run prepares for.
#include "diagnosis/verdict/outlier_forecasts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/diagnose.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/has.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

DiagnosisResult diagnosed(const MeasuredData& data) {
  DiagnoseOptions options;
  options.replicates = 100;
  options.hold_out = 0.3;
  return diagnose(data, Hardware{}, options);
}

const DataNote* outlier_note(const DiagnosisResult& result) {
  const auto found =
      std::find_if(result.notes.begin(), result.notes.end(),
                   [](const DataNote& note) { return note.kind == NoteKind::outlier_forecast; });
  return found == result.notes.end() ? nullptr : &*found;
}

MeasuredData planted(const PlantingPlan& plan, std::uint64_t seed) {
  return read_data(plant(plan, seed).csv);
}

TEST(OutlierForecasts, AreOfReadingsThatAreChangedWhereNothingElseIs) {
  MeasuredData data = planted({}, 81);
  const DiagnosisResult before = diagnosed(data);
  EXPECT_EQ(outlier_note(before), nullptr);
  for (const bool held_out : {true, false}) {
    const auto cell =
        std::find_if(before.cells.begin(), before.cells.end(), [&](const ComparedCell& each) {
          return each.held_out == held_out && each.cell.measured_N > 2;
        });
    ASSERT_NE(cell, before.cells.end());
    Reading& reading = data.readings[cell->cell.reading];
    std::optional<double>& tension = reading.tension_N[cell->cell.channel];
    const double was = *tension;
    *tension *= 2;
    const DiagnosisResult result = diagnosed(data);
    const DataNote* const note = outlier_note(result);
    EXPECT_EQ(note != nullptr, held_out);
    if (note != nullptr) {
      EXPECT_EQ(note->lines, std::vector<std::size_t>{reading.line});
      EXPECT_TRUE(has(note->text, "1 reading of held-out runs is more than"));
    }
    *tension = was;
  }
}

TEST(OutlierForecasts, AreOfHeldOutReadingsAlone) {
  const MeasuredData data = planted({}, 81);
  const DiagnosisResult result = diagnosed(data);
  for (const bool held_out : {true, false}) {
    std::vector<ComparedCell> cells = result.cells;
    const auto cell = std::find_if(cells.begin(), cells.end(), [&](const ComparedCell& each) {
      return each.held_out == held_out;
    });
    cell->residual_after = -50;
    EXPECT_EQ(outlier_forecasts(cells, data, result.noise, 0.02).has_value(), held_out);
  }
}

TEST(OutlierForecasts, AreNoneByChance) {
  SKIP_UNDER_SANITIZERS();
  for (const std::uint64_t seed : {1U, 6U}) {
    PlantingPlan plan;
    plan.noise.tail_degrees = seed % 2 == 0 ? 3 : 0;
    plan.noise.mounted_exponent = seed % 3 == 0 ? 0.08 : 0;
    EXPECT_EQ(outlier_note(diagnosed(planted(plan, seed))), nullptr) << seed;
  }
}

// The grasp of one row was another one, and no training run has it.
TEST(OutlierForecasts, ShowAWrongGraspOfOneRow) {
  PlantingPlan plan;
  plan.effects = {EffectKind::wrong_grasp};
  const DiagnosisResult result = diagnosed(planted(plan, 4937402093307926638U));
  EXPECT_EQ(result.verdict, Verdict::none);
  const DataNote* const note = outlier_note(result);
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->lines, std::vector<std::size_t>{58});
}

}  // namespace
}  // namespace reeve::testing
