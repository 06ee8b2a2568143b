#include "core/part_prices.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/network_of.hpp"

namespace reeve {
namespace {

using testing::network_of;

double cost_of(const std::string& word, const PartPrices& prices, const Hardware& hardware = {}) {
  const Network network = network_of(word);
  return cost(parts(network), tendon_length(mechanics(network, hardware)), prices);
}

// Each kind of part counted by hand: a digit of the cost for each.
TEST(Cost, CountsEveryKindOfPart) {
  PartPrices prices;
  prices.sheath = 1;
  prices.tube = 10;
  prices.tip_bearing = 100;
  prices.fixed_pulley = 1e3;
  prices.movable_pulley = 1e4;
  prices.block = 1e5;
  prices.bar = 1e6;
  prices.anchor = 1e7;
  prices.fixed_end = 1e8;
  prices.knot = 1e9;
  struct Row {
    const char* word;
    double cost;
  };
  for (const Row& row : std::vector<Row>{{"M-1-T-2-F", 100000031},
                                         {"M-1b-B-2-M", 1112},
                                         {"F-1-P-2b-F", 200010112},
                                         {"1-P-2-P-1", 1000020024},
                                         {"1b-T-2-P-1b", 1000010122},
                                         {"M-Y1+1x-Y1-2x", 20100001},
                                         {"M-Y1+F-1b-Y1-2-F", 200100111},
                                         {"M-W1+1x-W1-2x", 21000001},
                                         {"M-F+M-1-F", 200000012},
                                         {"M-B-Y1-B-Y1k+Y1-1x", 10102001}}) {
    EXPECT_EQ(cost_of(row.word, prices), row.cost) << row.word;
  }
}

// TR1: one motor-side segment, two strands of each finger.
TEST(Cost, PricesTheTendonByTheLengthsOfTheHardware) {
  PartPrices prices;
  prices.tendon_mm = 2;
  Hardware hardware;
  hardware.motor_side_mm = 40;
  hardware.strand_mm = 100;
  FingerHardware finger;
  finger.finger = 1;
  finger.strand_mm = 85;
  hardware.fingers = {finger};
  EXPECT_EQ(cost_of("M-1-T-2-F", prices, hardware), 2 * (40 + 2 * 85 + 2 * 100));
}

TEST(Cost, IsNothingWithoutPrices) { EXPECT_EQ(cost_of("1-P-2-P-1", {}), 0); }

}  // namespace
}  // namespace reeve
