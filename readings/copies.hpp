// Rows that equal another one in all tensions, motor tension included, whatever else they say (a
// row number, a time). They are copies, or coarse sensors that read the same twice.
//
// Chance: two rows at the same load agree in channel c with p_c ≈ min(1, q/(2√π σ)), where q is the
// step of the sensor and σ the scatter of its readings about their levels (polished_levels.hpp),
// taken as a share of the level, 0.3 % at least where the data are not simulated; of readings of 0,
// the share of all that are 0. So among the rows of one routing, grasp and direction
//
//   E = Σ Π p_c  over pairs of rows at the same load
//
// equal pairs are to be expected, where the load is the motor tension (or the first tension) and
// the product goes over all other channels. Equal rows are copies if chance gives less than one in
// a hundred of them, E < 0.01 · (rows that equal an earlier one). Else those are that stand in a
// stretch of k ≥ 3 successive equal rows, as a logger leaves that repeats its last value, if such a
// stretch is as improbable: n · (Π p_c)^(k−1) < 0.01 among n rows.
//
// Assumptions: errors of channels are independent at a given load, and about normal.
#pragma once

#include <cstddef>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

struct EqualRows {
  std::vector<std::size_t> copies;         // readings that repeat an earlier one of their run
  std::vector<std::size_t> copies_across;  // readings that repeat an earlier one of another run
  std::vector<std::size_t> by_chance;      // readings that equal an earlier one, as coarse steps
                                           // allow
};

// Each list ascending.
EqualRows equal_rows(const MeasuredData& data);

// Readings that are copies of an earlier one, of any run; ascending.
std::vector<std::size_t> repeated_readings(const MeasuredData& data);

// Adds a note on each of these lists that is not empty.
void note_equal_rows(MeasuredData& data);

}  // namespace reeve::readings
