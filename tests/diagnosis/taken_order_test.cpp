#include <gtest/gtest.h>

#include <vector>

#include "readings/row_order.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

std::vector<std::size_t> places_taken(const std::string& rows,
                                      const std::string& clock = "time_s") {
  const MeasuredData data = read_data("run,routing,motor_tension_N,T1_N," + clock + "\n" + rows);
  std::vector<std::size_t> places;
  for (const Reading& reading : data.readings) places.push_back(reading.taken);
  return places;
}

using Places = std::vector<std::size_t>;

TEST(TakenOrder, IsThatOfTheFileWithoutAClock) {
  EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,8\n2,TR3,12,1,7\n", "humidity"),
            (Places{0, 1, 2}));
}

TEST(TakenOrder, IsThatOfTheClock) {
  for (const char* clock : {"time_s", "Time [s]", "Time (ms)"}) {
    EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,8\n2,TR3,12,1,7\n", clock), (Places{2, 1, 0}))
        << clock;
  }
}

// Rows without a time would stand anywhere.
TEST(TakenOrder, IsThatOfTheFileWhereTheClockHasGaps) {
  EXPECT_EQ(places_taken("1,TR3,10,1,9\n1,TR3,11,1,\n2,TR3,12,1,7\n"), (Places{0, 1, 2}));
}

TEST(TakenOrder, HasRunsAsInTheFileWhereTheClockBeginsAgain) {
  EXPECT_EQ(places_taken("b,TR3,10,1,5\na,TR3,11,1,4\nb,TR3,12,1,2\na,TR3,13,1,1\n"),
            (Places{1, 3, 0, 2}));
}

TEST(TakenOrder, PutsADriftAlongTheClock) {
  const MeasuredData data = read_data(
      "run,routing,motor_tension_N,T1_N,time_s\n1,TR3,10,1,30\n1,TR3,11,1,10\n1,TR3,12,1,20\n");
  const Dataset dataset = all_of(data);
  EXPECT_EQ(dataset.rows[0].conditions.order, 1);
  EXPECT_EQ(dataset.rows[1].conditions.order, 0);
  EXPECT_EQ(dataset.rows[2].conditions.order, 0.5);
}

}  // namespace
}  // namespace reeve::testing
