// Measured data made ready for a diagnosis: repetitions dropped, thinned if there are too many,
// runs held out; and what is to be said about that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/dataset.hpp"
#include "readings/measured_data.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

// Splits the readings into those that a model is fitted to and those that it is tested on.
//
// Repeated readings are dropped first (and listed). Whole runs are held out, drawn by the seed
// among runs that were measured on the same routings, so that what is tested has been seen in
// training wherever there are two runs of it.
struct RunSplit {
  std::vector<std::size_t> training;  // readings, ascending
  std::vector<std::size_t> held_out;
  std::vector<std::size_t> held_out_runs;
  std::vector<std::size_t> dropped;  // readings that are copies of an earlier one
};

// `share` of the runs, at least one and not all, unless it is 0 or there is one run only. Without
// the incomplete readings (whole_columns.hpp).
RunSplit split_by_run(const MeasuredData& data, double share, std::uint64_t seed,
                      const std::vector<std::size_t>& incomplete = {});

// Readings that are no repetition, thinned evenly within each run to at most `most`.
std::vector<std::size_t> thinned(const MeasuredData& data, std::vector<std::size_t> readings,
                                 std::size_t most);

// More readings than this say nothing more about which cause it is.
inline constexpr std::size_t most_readings = 4000;

struct SampleCounts {
  std::size_t rows = 0;  // used, training and held out
  std::size_t runs = 0;
  // A result counts the runs that were forecast by a model that has not seen them: sealed ones,
  // or all of them where the folds forecast.
  std::size_t held_out_runs = 0;
  std::size_t dropped_duplicates = 0;
  std::size_t thinned_rows = 0;  // beyond most_readings
  std::vector<DataNote> notes;   // notes on the data come first
};

struct Sample : SampleCounts {
  Dataset training;
  Dataset held_out;
};

// `share` of the runs is held out. Throws InputError if no row can be compared.
// `data` must outlive the sample.
Sample sample(const MeasuredData& data, double share, std::uint64_t seed,
              const std::vector<std::size_t>& incomplete = {});

}  // namespace reeve::diagnosis
