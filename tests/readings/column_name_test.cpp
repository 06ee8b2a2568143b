#include "readings/column_name.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/support/input_error.hpp"

namespace reeve::testing {
namespace {

// "motor_tension_N in lbf"; a star needs a unit, and what is no known name is "-".
std::string read_as(const std::string& name) {
  const auto found = column_named(name);
  if (!found) return "-";
  return plain_name(*found) + (found->unit ? std::string(" in ") + found->unit->name : "") +
         (found->needs_unit ? " *" : "");
}

void expect_read(const std::map<std::string, std::string>& meanings) {
  for (const auto& [name, meaning] : meanings) EXPECT_EQ(read_as(name), meaning) << name;
}

TEST(ColumnName, IsReadInAnySpelling) {
  for (const char* name : {"motor_tension_N", "Motor Tension [N]", "MOTOR-TENSION (n)",
                           "motorTension_N", " motor.tension N ", "motor_force_N"}) {
    EXPECT_EQ(read_as(name), "motor_tension_N in N") << name;
  }
  EXPECT_EQ(read_as("Motor Tension"), "motor_tension_N");
  for (const char* name : {"T1_N", "t1_n", "T1 [N]", "T1 (N)", "T_1_N", "T01_N"}) {
    EXPECT_EQ(read_as(name), "T1_N in N") << name;
  }
  expect_read({{"T1", "T1_N"},
               {"Run", "run"},
               {"HELD [-]", "held"},
               {"Sheath angle (deg)", "sheath_angle_rad in deg"},
               {"speed_m_s", "speed_mm_s in m/s"},
               {"Speed [mm/s]", "speed_mm_s in mm/s"},
               {"temperature_F", "temperature_C in °F"}});
}

TEST(ColumnName, OfALetterNeedsAUnitToBeATension) {
  expect_read({{"Ta_N", "Ta_N in N *"},
               {"TA [lbf]", "Ta_N in lbf *"},
               {"Th1_kgf", "Th1_N in kgf *"},
               {"Ta", "Ta_N *"}});
}

TEST(ColumnName, IsNoTensionWithAUnitOfSomethingElse) {
  for (const char* name : {"T1 [°C]", "T1_C", "Ta (degC)", "T0", "Tmax_N", "T_N [K]", "T1 [MN]",
                           "motor tension (set)", "at_Ta_N", "speed [N]"}) {
    EXPECT_EQ(read_as(name), "-") << name;
  }
}

TEST(ColumnName, OfALogIsReadInAnySpelling) {
  expect_read({{"Time", "time_s"},
               {"Time [s]", "time_s in s"},
               {"time (ms)", "time_s in ms"},
               {"timestamp_us", "time_s in µs"},
               {"t [min]", "time_s in min"},
               {"T [s]", "time_s in s"},
               {"Position_mm", "position_mm in mm"},
               {"pos_mm", "position_mm in mm"},
               {"position_cm", "position_mm in cm"},
               {"Position [m]", "position_mm in m"},
               {"POS", "position_mm"}});
}

TEST(ColumnName, OfALetterAloneIsNoTimeUnlessItSaysSo) {
  expect_read({{"t", "time_s"}, {"t_s", "time_s in s"}, {"t_ms", "time_s in ms"}});
  for (const char* name : {"T", "T_s", "T_min", "t_min", "T [K]"}) {
    EXPECT_NE(read_as(name).substr(0, 4), "time") << name;
  }
}

TEST(ColumnName, OfAPlaceOrADeviation) {
  expect_read({{"at_T1_N", "at_T1_N in N"},
               {"At T12 [lbf]", "at_T12_N in lbf"},
               {"T1_sd_N", "T1_sd_N in N"},
               {"T1 SD", "T1_sd_N"},
               {"Ta_sd_N", "Ta_sd_N in N *"},
               {"at_T1_sd_N", "at_T1_sd_N in N"},
               {"readings", "readings"}});
}

TEST(Unit, IsConvertedAsTheStandardsSay) {
  const auto value = [](const char* unit, Dimension dimension, double x) {
    return find_unit(unit, dimension)->converted(x);
  };
  EXPECT_DOUBLE_EQ(value("lbf", Dimension::force, 1), 4.4482216152605);
  EXPECT_DOUBLE_EQ(value("kg", Dimension::force, 2), 19.6133);
  EXPECT_DOUBLE_EQ(value("g", Dimension::force, 100), 0.980665);
  EXPECT_DOUBLE_EQ(value("ozf", Dimension::force, 16), 4.4482216152605);
  EXPECT_DOUBLE_EQ(value("mN", Dimension::force, 1), 0.001);
  EXPECT_DOUBLE_EQ(value("m/s", Dimension::speed, 0.5), 500);
  EXPECT_DOUBLE_EQ(value("m/min", Dimension::speed, 6), 100);
  EXPECT_NEAR(value("degF", Dimension::temperature, 212), 100, 1e-12);
  EXPECT_NEAR(value("K", Dimension::temperature, 300), 26.85, 1e-12);
  EXPECT_DOUBLE_EQ(value("[°]", Dimension::angle, 180), 3.14159265358979312);
  EXPECT_DOUBLE_EQ(value("inch", Dimension::length, 2), 50.8);
  EXPECT_DOUBLE_EQ(value("um", Dimension::length, 5), 0.005);
  EXPECT_DOUBLE_EQ(value("µs", Dimension::time, 3e6), 3);
  EXPECT_FALSE(find_unit("lbf", Dimension::speed));
  const Unit fahrenheit = *find_unit("°F", Dimension::temperature);
  EXPECT_NEAR(fahrenheit.back(fahrenheit.converted(71)), 71, 1e-12);
}

}  // namespace
}  // namespace reeve::testing
