// Which readings a model is fitted to, and which it is tested on.
//
// Repeated readings are dropped first (and listed). Whole runs are held out, drawn by the seed
// among runs that were measured on the same routings, so that what is tested has been seen in
// training wherever there are two runs of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

struct RunSplit {
  std::vector<std::size_t> training;  // readings, ascending
  std::vector<std::size_t> held_out;
  std::vector<std::size_t> held_out_runs;
  std::vector<std::size_t> dropped;  // readings that are copies of an earlier one
};

// `share` of the runs, at least one and not all, unless it is 0 or there is one run only.
RunSplit split_by_run(const MeasuredData& data, double share, std::uint64_t seed);

// Readings that are no repetition, thinned evenly within each run to at most `most`.
std::vector<std::size_t> thinned(const MeasuredData& data, std::vector<std::size_t> readings,
                                 std::size_t most);

}  // namespace reeve::diagnosis
