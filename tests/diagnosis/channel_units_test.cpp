// Sensors of planted data in another unit.
#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/verdict/model_doubts.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/has.hpp"
#include "tests/support/planting.hpp"

namespace reeve::testing {
namespace {

constexpr std::size_t all_channels = 100;

std::vector<DataNote> notes_with(double factor, std::size_t channels) {
  MeasuredData data = read_data(plant({}, 81).csv);
  for (Reading& reading : data.readings) {
    for (std::size_t c = 0; c < std::min(channels, data.channels.size()); ++c) {
      if (reading.tension_N[c]) *reading.tension_N[c] *= factor;
    }
  }
  return notes_on_channel_units(all_of(data), {});
}

TEST(AChannelsUnit, IsQuestionedWhereThatChannelAloneIsOff) {
  for (const auto& [factor, unit] :
       {std::pair(1 / 9.80665, "is it in kgf?"), std::pair(1 / 4.44822, "is it in lbf?"),
        std::pair(1e-3, "is it in kN?"), std::pair(9.80665, "is it in newton, and taken for kgf?"),
        std::pair(1e3, "is it in newton, and taken for kN?")}) {
    const std::vector<DataNote> notes = notes_with(factor, 1);
    ASSERT_EQ(notes.size(), 1U) << factor;
    EXPECT_EQ(notes[0].kind, NoteKind::units);
    EXPECT_TRUE(has(notes[0].text, "T1_N reads "));
    EXPECT_TRUE(has(notes[0].text, unit));
  }
}

TEST(AChannelsUnit, IsQuestionedOfSeveralAtOnce) {
  const std::vector<DataNote> several = notes_with(1 / 4.44822, 3);
  ASSERT_EQ(several.size(), 1U);
  EXPECT_TRUE(has(several[0].text,
                  "T1_N, T2_N, T3_N read about 0.225 times what the model says, and no other "
                  "channel is off like that: are they in lbf?"));
  const std::vector<DataNote> of_all = notes_with(1 / 4.44822, all_channels);
  ASSERT_EQ(of_all.size(), 1U);
  EXPECT_TRUE(has(of_all[0].text, "what the model says with the motor's tension: are they in lbf?"))
      << of_all[0].text;
}

TEST(AChannelsUnit, IsNotQuestionedForGains) {
  for (const double factor : {1.0, 0.5, 2.0, 0.16, 6.0}) {
    EXPECT_TRUE(notes_with(factor, 1).empty()) << factor;
    EXPECT_TRUE(notes_with(factor, all_channels).empty()) << factor;
  }
}

}  // namespace
}  // namespace reeve::testing
