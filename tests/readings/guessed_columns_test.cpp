#include "readings/log/guessed_columns.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/has.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::readings {
namespace {

using testing::has;

LogGuess guess(const std::string& text, const ReadingOptions& options = {}) {
  const testing::TemporaryFolder folder;
  return guess_columns(folder.write("log.csv", text), options);
}

std::string meanings(const LogGuess& guessed) {
  std::string text;
  for (const GuessedColumn& column : guessed.columns) {
    text += (text.empty() ? "" : " ") + (column.meaning.empty() ? "-" : column.meaning);
  }
  return text;
}

TEST(GuessedColumns, AreThoseOfAGermanLogger) {
  const LogGuess guessed = guess(
      "Zeit [s];Weg [mm];Geschwindigkeit [mm/s];Motorkraft [N];Kraft 1 [N];Kraft 2 [N];"
      "Motorstrom [A];Temperatur [°C]\n0,00;0,0;1,0;12,5;6,1;5,0;0,8;21,5\n");
  EXPECT_EQ(guessed.separator, ';');
  EXPECT_EQ(meanings(guessed), "time position speed motor_tension T1 T2 - temperature");
  EXPECT_TRUE(has(guessed.columns[6].reason, "a current is no tension"));
  EXPECT_EQ(guessed.columns[4].kind, GuessKind::guessed);
  EXPECT_EQ(guessed.first_rows, (std::vector<std::vector<std::string>>{
                                    {"0,00", "0,0", "1,0", "12,5", "6,1", "5,0", "0,8", "21,5"}}));
}

TEST(GuessedColumns, AreThoseOfAnEnglishLogger) {
  EXPECT_EQ(meanings(guess("Elapsed Time (ms),Travel (mm),Load Cell 1 (lbf),Force_2 (lbf),"
                           "Actuator force (lbf),Motor torque (Nm),Trial\n")),
            "time position T1 T2 motor_tension - run");
}

TEST(GuessedColumns, LeaveNamesThatAreKnownAsTheyAre) {
  const LogGuess guessed = guess("time_s,T1_N,Kraft 1 [N],note\n");
  EXPECT_EQ(meanings(guessed), "time T1 - -");
  EXPECT_EQ(guessed.columns[0].kind, GuessKind::known);
  EXPECT_EQ(guessed.columns[2].reason, "it would be T1, and so is 'T1_N'");
  EXPECT_TRUE(guessed.map.empty());
}

TEST(GuessedColumns, TakeUnitsFromTheRowBelow) {
  const LogGuess guessed = guess("Zeit;Kraft 1;Kraft 2\ns;N;V\n0;1;2\n");
  EXPECT_EQ(meanings(guessed), "time T1 -");
  EXPECT_TRUE(has(guessed.columns[2].reason, "'V' is no unit of force"));
  EXPECT_EQ(guessed.first_rows.size(), 1U);
}

TEST(GuessedColumns, AskOfWhichStrandATensionIs) {
  const LogGuess guessed = guess("Zeit [s];Kraft [N];Kraft 0 [N]\n");
  EXPECT_EQ(meanings(guessed), "time - -");
  EXPECT_TRUE(has(guessed.columns[1].reason, "of which strand?"));
}

TEST(GuessedColumns, FollowWhatTheUserSays) {
  ReadingOptions options;
  options.map = {{"Kraft 1 [N]", "motor_tension"}};
  const LogGuess guessed = guess("Zeit [s];Kraft 1 [N];Kraft 2 [N]\n", options);
  EXPECT_EQ(meanings(guessed), "time motor_tension T2");
  EXPECT_EQ(guessed.map.size(), 3U);
}

}  // namespace
}  // namespace reeve::readings
