// Measured data made ready for a diagnosis: repetitions dropped, thinned if there are too many,
// runs held out; and what is to be said about that.
#pragma once

#include <cstdint>
#include <vector>

#include "diagnosis/dataset.hpp"
#include "readings/note.hpp"

namespace reeve::diagnosis {

// More readings than this say nothing more about which cause it is.
inline constexpr std::size_t most_readings = 4000;

struct Sample {
  Dataset training;
  Dataset held_out;
  std::size_t rows = 0;  // of both
  std::size_t runs = 0;
  std::size_t held_out_runs = 0;
  std::size_t dropped_duplicates = 0;
  std::size_t thinned_rows = 0;
  std::vector<DataNote> notes;  // those on the data first
};

// `share` of the runs is held out (run_split.hpp). Throws InputError if no row can be compared.
// `data` must outlive the sample.
Sample sample(const MeasuredData& data, double share, std::uint64_t seed);

}  // namespace reeve::diagnosis
