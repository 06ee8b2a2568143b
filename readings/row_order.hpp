// Readings in an order that follows from what they say, not from their places in a file.
//
// A diagnosis draws by number: which runs it holds out, what noise its replicates have, which runs
// it resamples. A table that somebody has sorted or shuffled must not draw otherwise, nor one with
// its columns exchanged. So runs come by their names (numbers in them as numbers: 2 before 10), the
// readings of a run by cycle, routing, grasp, direction, conditions and tensions, routings and
// groups as these readings first have them, and channels by their segment. When a row was taken is
// another question (set_taken).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::readings {

MeasuredData in_order_of_contents(MeasuredData data);

// True if a comes before b; digits in a row count as one number.
bool natural_less(std::string_view a, std::string_view b);

// Returns the number of each run: where the names are alike but for their last whole number
// (m3, m12, m13), that number, which a later file goes on with; else 1, 2, ….
std::vector<double> run_numbers(const std::vector<std::string>& runs);

// The covariate that is a clock, which every row has.
std::optional<std::size_t> clock_of(const MeasuredData& data);

// Sets the order in which readings were taken, Reading::taken: by the clock where every row has
// one, else as the file has them. A clock may begin again with each run; runs then follow one
// another as in the file.
void set_taken(MeasuredData& data);

}  // namespace reeve::readings
