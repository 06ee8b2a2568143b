// Keys that the JSON of several commands has of a design and of what was asked.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {

inline const std::string objectives =
    " uniformity efficiency force_transmission jams jams_all sheaths pulleys knots travel "
    "round_trip_efficiency adaptability torsional_balance reliability authors_efficiency transmission score "
    "blocks finger_uniformity parts cost uniformity_p5 efficiency_p5";
inline const std::string equivalent = " smallest_jams alike same_as place";
inline const std::string evaluated_settings = "objectives score grasps hardware model uncertainty";
inline const std::string common_settings = evaluated_settings + " tradeoff prices sweep";

inline void expect_pair(const Json& json) {
  EXPECT_EQ(keys(json["uniformity"]), "mean worst");
  EXPECT_EQ(keys(json["efficiency"]), "mean worst");
}

inline void expect_settings(const Json& settings) {
  EXPECT_EQ(keys(settings["grasps"][0]), "held weight");
  EXPECT_EQ(keys(settings["hardware"]), "tube bearing sheath scatter lengths fingers contacts");
  EXPECT_EQ(keys(settings["hardware"]["tube"]), "mu angle_rad");
  EXPECT_EQ(keys(settings["hardware"]["lengths"]), "strand_mm motor_side_mm hand_mm");
}

}  // namespace reeve::testing
